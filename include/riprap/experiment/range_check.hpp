#pragma once
/// @file
/// Says when a dimensionless number leaves the range in which a biaxial test means something.

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/experiment/stage.hpp>
#include <riprap/measurement/average_stress.hpp>
#include <riprap/measurement/dimensionless.hpp>

namespace riprap {

/// Ends of the ranges.
struct Limits {
  double stiffness_level = 0.05;   ///< kappa; above: particles too soft
  double inertial_number = 1e-3;   ///< above: not quasi-static
  double overlap_ratio = 0.05;     ///< mean overlap over mean diameter; above: particles too soft
  double kinetic_ratio = 0.02;     ///< kinetic over stored energy, after 1 % strain
  double unbalanced_force = 0.15;  ///< mean resultant over mean contact force, after 1 % strain
  double time_step_ratio = 0.25;   ///< dt over sqrt(m / k) of the lightest body
  double least_stiffness_level = 1e-6;  ///< kappa; below: no end in sight, or a slip of units
  /// Confining pressure over the criterion's uniaxial compressive strength; above: all particles
  /// fail at once, or a slip of units.
  double pressure_over_strength = 0.5;
};

/// An observer of BiaxialTest that collects a warning for each number the first time it is out of
/// range, and for each stage that ended at its cap of steps.
class RangeCheck {
 public:
  explicit RangeCheck(Limits limits = {}) : limits_(limits) {}

  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

  template <class Sim>
  void begin_stage(const BiaxialView<Sim>& view) {
    if (view.stage == Stage::compaction) check_units(view);
    if (view.stage != Stage::hydrostatic) return;
    const double mean = stress(view).mean();
    if (mean > view.confining_pressure)
      warnings_.push_back("relaxation left a mean stress of " + to_text(mean) +
                          " Pa, above the confining pressure: the sample is unloaded to it");
    check(view, "stiffness level kappa", limits_.stiffness_level, kappa(view));
  }

  template <class Sim>
  void record(const BiaxialView<Sim>& view) {
    const Particles& particles = view.sim.particles();
    const StateNumbers state = state_numbers(view.sim.contacts(), particles, view.sim.body_force());
    check(view, "inertial number", limits_.inertial_number,
          inertial_number(view.rate.y(), view.mean_diameter, particles.density(),
                          stress(view).mean()));
    check(view, "mean overlap over mean diameter", limits_.overlap_ratio,
          state.mean_overlap / view.mean_diameter);
    check(view, "time step over sqrt(m/k)", limits_.time_step_ratio,
          time_step_ratio(view.sim.time_step(), particles,
                          view.sim.contacts().law().peak_stiffness()));
    const auto lost = view.sim.boundary().region(particles).lost();
    check(view, "particles outside the boundary", 0, static_cast<double>(lost));
    if (view.axial_strain() < 0.01) return;
    check(view, "kinetic over stored energy", limits_.kinetic_ratio, state.kinetic_ratio());
    check(view, "unbalanced force", limits_.unbalanced_force, state.unbalanced_force);
  }

  template <class Sim>
  void end_stage(const BiaxialView<Sim>& view) {
    if (!view.reached_target && !view.interrupted)
      warnings_.push_back(std::string(to_text(view.stage)) +
                          ": ended at its cap of steps, target not reached");
  }

 private:
  template <class Sim>
  [[nodiscard]] static Stress2 stress(const BiaxialView<Sim>& view) {
    return average_stress(view.sim.contacts(), view.area, view.sim.particles().thickness());
  }

  template <class Sim>
  [[nodiscard]] static double kappa(const BiaxialView<Sim>& view) {
    return stiffness_level(view.confining_pressure, view.sim.particles().thickness(),
                           view.sim.contacts().law().peak_stiffness());
  }

  // Before the first step, for what is wrong now costs hours.
  template <class Sim>
  [[gnu::cold]] void check_units(const BiaxialView<Sim>& view) {
    if (kappa(view) < limits_.least_stiffness_level)
      warnings_.push_back("stiffness level kappa = " + to_text(kappa(view)) + " below " +
                          to_text(limits_.least_stiffness_level) +
                          ": is the confining pressure in Pa?");
    if constexpr (requires { view.sim.model().breakage_model.criterion; }) {
      const auto& criterion = view.sim.model().breakage_model.criterion;
      const double ratio = view.confining_pressure / criterion.major_stress_at_failure(0);
      if (ratio > limits_.pressure_over_strength)
        warnings_.push_back("confining pressure over uniaxial strength = " + to_text(ratio) +
                            " above " + to_text(limits_.pressure_over_strength) +
                            ": is the strength in Pa?");
    }
  }

  template <class Sim>
  void check(const BiaxialView<Sim>& view, std::string_view name, double limit, double value) {
    if (value > limit) warn(view, name, limit, value);
  }

  template <class Sim>
  [[gnu::cold]] void warn(const BiaxialView<Sim>& view, std::string_view name, double limit,
                          double value) {
    if (!seen_.emplace(name).second) return;
    warnings_.push_back(std::string(name) + " = " + to_text(value) + " above " + to_text(limit) +
                        " at strain " + to_text(view.axial_strain()) + " of " +
                        to_text(view.stage));
  }

  Limits limits_;
  std::set<std::string> seen_;
  std::vector<std::string> warnings_;
};

}  // namespace riprap
