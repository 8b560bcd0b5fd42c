// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Conditions that end a stage at a strain, a stress or a number of steps.

#include <array>
#include <cstdint>
#include <string>

#include <riprap/core/errors.hpp>

namespace riprap {

/// A number that a condition watches comes to its target from where it is at the start, from below
/// or from above.
struct Crossing {
  double first = 0;

  void begin(double value) { first = value; }
  [[nodiscard]] bool reached(double value, double target) const {
    return first <= target ? value >= target : value <= target;
  }
  [[nodiscard]] double done(double value, double target) const {
    return (value - first) / (target - first);
  }

  static void for_each_field(auto& self, auto&& visit) { visit("first", self.first); }
};

enum class StrainOf { axis_1, axis_2, volume };
enum class StressOf { axis_1, axis_2, mean, difference };

[[nodiscard]] constexpr auto names_of(StrainOf) { return std::array{"axis 1", "axis 2", "volume"}; }
[[nodiscard]] constexpr auto names_of(StressOf) {
  return std::array{"axis 1", "axis 2", "mean", "difference"};
}

/// A strain is reached: engineering strain of an axis, positive in shortening, or volumetric
/// strain, positive in contraction. Asked at every step.
struct StrainReached {
  static constexpr const char* name = "strain";
  double strain = 0;
  StrainOf of = StrainOf::axis_2;
  Crossing crossing{};  ///< state

  template <class View>
  void begin(const View& view) {
    crossing.begin(value(view));
  }
  template <class View>
  [[nodiscard]] bool reached(const View& view) const {
    return crossing.reached(value(view), strain);
  }
  template <class View>
  [[nodiscard]] double done(const View& view) const {
    return crossing.done(value(view), strain);
  }
  void validate(const std::string& owner) const {
    require(strain > -9 && strain < 0.9, owner + ".strain", strain, "must lie in (-9, 0.9)");
  }

  template <class Self, class Visit>
  static void for_each_parameter(Self& self, Visit&& visit) {
    visit("strain", self.strain);
    visit("of", self.of);
  }
  static void for_each_field(auto& self, auto&& visit) { visit("crossing", self.crossing); }

 private:
  template <class View>
  [[nodiscard]] double value(const View& view) const {
    return of == StrainOf::volume ? view.volumetric_strain()
                                  : view.strain(of == StrainOf::axis_1 ? 1 : 2);
  }
};

/// A stress is reached for the first time: a normal stress, their mean, or the difference
/// sigma_22 - sigma_11. Asked at every step.
struct StressReached {
  static constexpr const char* name = "stress";
  double stress = 0;  ///< [Pa]
  StressOf of = StressOf::axis_2;
  Crossing crossing{};  ///< state

  template <class View>
  void begin(const View& view) {
    crossing.begin(value(view));
  }
  template <class View>
  [[nodiscard]] bool reached(const View& view) const {
    return crossing.reached(value(view), stress);
  }
  template <class View>
  [[nodiscard]] double done(const View& view) const {
    return crossing.done(value(view), stress);
  }
  void validate(const std::string& owner) const { require_finite(owner + ".stress", stress); }

  template <class Self, class Visit>
  static void for_each_parameter(Self& self, Visit&& visit) {
    visit("stress", self.stress);
    visit("of", self.of);
  }
  static void for_each_field(auto& self, auto&& visit) { visit("crossing", self.crossing); }

 private:
  template <class View>
  [[nodiscard]] double value(const View& view) const {
    switch (of) {
    case StressOf::axis_1:
      return view.stress().s11;
    case StressOf::axis_2:
      return view.stress().s22;
    case StressOf::mean:
      return view.stress().mean();
    case StressOf::difference:
      return view.stress().s22 - view.stress().s11;
    }
    return 0;
  }
};

/// A number of steps of the stage.
struct StepsMade {
  static constexpr const char* name = "steps";
  std::uint64_t steps = 0;

  template <class View>
  [[nodiscard]] bool reached(const View& view) const {
    return view.stage_steps >= steps;
  }
  template <class View>
  [[nodiscard]] double done(const View& view) const {
    return static_cast<double>(view.stage_steps) / static_cast<double>(steps);
  }

  template <class Self, class Visit>
  static void for_each_parameter(Self& self, Visit&& visit) {
    visit("steps", self.steps);
  }
  static void for_each_field(auto&, auto&&) {}
};

}  // namespace riprap
