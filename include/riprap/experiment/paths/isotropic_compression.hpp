// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Isotropic compression, unloading and reloading.

#include <cstdint>
#include <string>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/experiment/loading_stage.hpp>

namespace riprap {

/// Both normal stresses go to one pressure after the other, where a lower one unloads; each step of
/// load ends in equilibrium. The states at the ends of loading lie on the normal compression line.
struct IsotropicCompression {
  std::vector<double> pressures{4e6, 8e6, 16e6, 2e6};  ///< [Pa]
  double inertial_number = 1e-3;  ///< of the fastest rate, at the path's confining pressure
  double tolerance = 0.01;        ///< on both normal stresses at the end of a step of load
  double unbalanced_force = 1e-2;
  double record_every = 0.001;           ///< axial strain between records [-]
  std::uint64_t most_steps = 2'000'000;  ///< of a stage

  /// From the pressure at the start [Pa]. Throws InvalidInput that names value and rule.
  [[nodiscard]] std::vector<LoadingStage<>> stages(double from) const {
    require_positive("IsotropicCompression.inertial_number", inertial_number);
    std::vector<LoadingStage<>> stages;
    for (const double pressure : pressures) {
      require_positive("IsotropicCompression.pressures", pressure);
      const ControlledStress servo{
          .stress = pressure,
          .control = {.expected_rate = {.inertial_number = inertial_number}, .largest_rate = 1}};
      stages.push_back(
          {.name = (pressure < from ? "unloading to " : "loading to ") + to_text(pressure) + " Pa",
           .axis_1 = servo,
           .axis_2 = servo,
           .end = StressesHeld{.stress_1 = pressure,
                               .stress_2 = pressure,
                               .tolerance = tolerance,
                               .unbalanced_force = unbalanced_force},
           .record_every = record_every,
           .most_steps = most_steps});
      from = pressure;
    }
    return stages;
  }
};

}  // namespace riprap
