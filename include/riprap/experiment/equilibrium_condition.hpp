// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Conditions that end a stage in equilibrium, or when the sample jams.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include <riprap/core/errors.hpp>
#include <riprap/measurement/dimensionless.hpp>
#include <riprap/measurement/energy.hpp>

namespace riprap {

/// A slow sample under stress: the end of compaction.
struct Jammed {
  static constexpr const char* name = "jammed";
  double pressure = 2e5;        ///< mean stress [Pa]
  double kinetic_ratio = 0.04;  ///< kinetic over stored energy below which it counts as slow
  double distance = 1;          ///< state: estimated volumetric strain to the end

  template <class View>
  void begin(const View& view) {
    // A jammed sample of sharp polygons fills about 0.8 of its boundary polygon.
    const double solid = view.sim.boundary().region(view.sim.particles()).solid_area();
    distance = std::log(view.area * 0.8 / solid);
  }
  template <class View>
  [[nodiscard]] bool reached(const View& view) const {
    return view.at_check && view.stress().mean() >= pressure &&
           kinetic_energy(view.sim.particles()) <= kinetic_ratio * stored_energy_of(view.sim);
  }
  template <class View>
  [[nodiscard]] double done(const View& view) const {
    return -std::log(view.stretch.x() * view.stretch.y()) / distance;
  }
  void validate(const std::string& owner) const {
    require_positive(owner + ".pressure", pressure);
    require_positive(owner + ".kinetic_ratio", kinetic_ratio);
  }

  template <class Self, class Visit>
  static void for_each_parameter(Self& self, Visit&& visit) {
    visit("pressure", self.pressure);
    visit("kinetic_ratio", self.kinetic_ratio);
  }
  static void for_each_field(auto& self, auto&& visit) { visit("distance", self.distance); }
};

/// Equilibrium, whatever the stress.
struct RestReached {
  static constexpr const char* name = "rest";
  double unbalanced_force = 1e-3;  ///< mean resultant over mean contact force
  double first = 1;                ///< state: that at the start

  template <class View>
  void begin(const View& view) {
    first = unbalanced_force_of(view);
  }
  template <class View>
  [[nodiscard]] bool reached(const View& view) const {
    return view.at_check && unbalanced_force_of(view) < unbalanced_force;
  }
  template <class View>
  [[nodiscard]] double done(const View& view) const {
    return std::log(unbalanced_force_of(view) / first) / std::log(unbalanced_force / first);
  }
  void validate(const std::string& owner) const {
    require_positive(owner + ".unbalanced_force", unbalanced_force);
  }

  template <class Self, class Visit>
  static void for_each_parameter(Self& self, Visit&& visit) {
    visit("unbalanced_force", self.unbalanced_force);
  }
  static void for_each_field(auto& self, auto&& visit) { visit("first", self.first); }

  template <class View>
  [[nodiscard]] static double unbalanced_force_of(const View& view) {
    return state_averages(view.sim).unbalanced_force;
  }
};

/// Both normal stresses near their values and the sample near equilibrium, in several checks in a
/// row.
struct StressesHeld {
  static constexpr const char* name = "stresses held";
  double stress_1 = 0;      ///< [Pa]; 0: any
  double stress_2 = 0;      ///< [Pa]; 0: any
  double tolerance = 0.01;  ///< on both [-]
  double unbalanced_force = 1e-2;
  std::uint64_t quiet_checks = 8;  ///< in a row
  std::uint64_t quiet = 0;         ///< state: checks passed in a row
  double first = 1;                ///< state: the largest error at the start

  template <class View>
  void begin(const View& view) {
    quiet = 0;
    first = error(view);
  }
  template <class View>
  [[nodiscard]] bool reached(const View& view) {
    if (!view.at_check) return false;
    const bool good =
        error(view) <= tolerance && RestReached::unbalanced_force_of(view) < unbalanced_force;
    quiet = good ? quiet + 1 : 0;
    return quiet >= quiet_checks;
  }
  template <class View>
  [[nodiscard]] double done(const View& view) const {
    return 0.9 * (1 - error(view) / first);
  }
  void validate(const std::string& owner) const {
    require_non_negative(owner + ".stress_1", stress_1);
    require_non_negative(owner + ".stress_2", stress_2);
    require_positive(owner + ".tolerance", tolerance);
    require_positive(owner + ".unbalanced_force", unbalanced_force);
  }

  template <class Self, class Visit>
  static void for_each_parameter(Self& self, Visit&& visit) {
    visit("stress_1", self.stress_1);
    visit("stress_2", self.stress_2);
    visit("tolerance", self.tolerance);
    visit("unbalanced_force", self.unbalanced_force);
    visit("quiet_checks", self.quiet_checks);
  }
  static void for_each_field(auto& self, auto&& visit) {
    visit("quiet", self.quiet);
    visit("first", self.first);
  }

 private:
  template <class View>
  [[nodiscard]] double error(const View& view) const {
    double largest = 0;
    if (stress_1 > 0) largest = std::abs(view.stress(1) - stress_1) / stress_1;
    if (stress_2 > 0) largest = std::max(largest, std::abs(view.stress(2) - stress_2) / stress_2);
    return largest;
  }
};

}  // namespace riprap
