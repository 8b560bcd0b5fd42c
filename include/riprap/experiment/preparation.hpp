// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// How a sample is prepared: compaction, relaxation, hydrostatic pressure.

#include <cstdint>
#include <string>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/experiment/loading_stage.hpp>

namespace riprap {

/// The three stages before a sample is loaded. Nothing breaks in the first two.
struct Preparation {
  double inertial_number = 1e-3;    ///< of the servos' rates, at the confining pressure
  double jam_pressure = 2e5;        ///< mean stress at which a slow sample counts as jammed [Pa]
  double jam_kinetic_ratio = 0.04;  ///< kinetic over stored energy below which it counts as slow
  double compaction_inertial_number = 2e-3;  ///< of compaction, at the jam pressure
  double rest_unbalanced_force = 1e-3;       ///< that ends relaxation
  double hydrostatic_tolerance = 0.01;       ///< on both normal stresses
  double hydrostatic_unbalanced_force = 1e-2;
  std::uint64_t most_steps = 2'000'000;  ///< per stage

  /// Throws InvalidInput that names the value and the rule.
  void validate(const std::string& owner = "Preparation") const {
    for_each_parameter(*this, [&](const char* name, const auto& value) {
      require_positive(owner + "." + name, static_cast<double>(value));
    });
  }

  template <class Self, class Visit>
  static void for_each_parameter(Self& self, Visit&& visit) {
    visit("inertial_number", self.inertial_number);
    visit("jam_pressure", self.jam_pressure);
    visit("jam_kinetic_ratio", self.jam_kinetic_ratio);
    visit("compaction_inertial_number", self.compaction_inertial_number);
    visit("rest_unbalanced_force", self.rest_unbalanced_force);
    visit("hydrostatic_tolerance", self.hydrostatic_tolerance);
    visit("hydrostatic_unbalanced_force", self.hydrostatic_unbalanced_force);
    visit("most_steps", self.most_steps);
  }

  /// Up to a hydrostatic pressure [Pa].
  [[nodiscard]] std::vector<LoadingStage<>> stages(double pressure) const {
    validate();
    return {compaction(), relaxation(), confining(pressure)};
  }

  /// Constant rate, without friction where the law has friction, until slow and under stress. All
  /// particles start with the velocity of the field, so that the sample contracts as a whole.
  [[nodiscard]] LoadingStage<> compaction() const {
    const LogarithmicRate closing{
        .rate_of_strain = {.inertial_number = compaction_inertial_number, .pressure = jam_pressure},
        .smooth = false};
    return {.name = "compaction",
            .axis_1 = closing,
            .axis_2 = closing,
            .end = Jammed{.pressure = jam_pressure, .kinetic_ratio = jam_kinetic_ratio},
            .part = Stage::compaction,
            .breakage = false,
            .friction = false,
            .affine_start = true,
            .records = false,
            .most_steps = most_steps,
            .at_cap = AtCap::error};
  }

  /// At rest between fixed boundaries.
  [[nodiscard]] LoadingStage<> relaxation() const {
    return {.name = "relaxation",
            .end = RestReached{.unbalanced_force = rest_unbalanced_force},
            .part = Stage::relaxation,
            .breakage = false,
            .records = false,
            .most_steps = most_steps};
  }

  /// To the pressure on both axes.
  [[nodiscard]] LoadingStage<> confining(double pressure) const {
    const ControlledStress servo{
        .stress = pressure,
        .control = {.expected_rate = {.inertial_number = inertial_number, .pressure = pressure},
                    .largest_rate = 2}};
    return {.name = "hydrostatic",
            .axis_1 = servo,
            .axis_2 = servo,
            .end = StressesHeld{.stress_1 = pressure,
                                .stress_2 = pressure,
                                .tolerance = hydrostatic_tolerance,
                                .unbalanced_force = hydrostatic_unbalanced_force},
            .part = Stage::hydrostatic,
            .records = false,
            .most_steps = most_steps};
  }
};

}  // namespace riprap
