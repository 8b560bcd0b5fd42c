// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Biaxial shear to and fro between limits.

#include <cstdint>
#include <string>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/experiment/loading_stage.hpp>

namespace riprap {

/// Cycles at constant sigma_11, between two axial strains, or between two values of
/// sigma_22 - sigma_11 where `by_stress`. A cycle goes to the upper limit, then to the lower one.
struct CyclicShear {
  double lower = -0.002;  ///< axial strain [-], or stress [Pa]
  double upper = 0.002;
  bool by_stress = false;
  int cycles = 10;
  double pressure = 2e6;  ///< sigma_11 [Pa]
  double inertial_number = 1e-3;
  double record_every = 0.0005;  ///< axial strain between records [-]
  double tolerance = 0.05;       ///< on the mean error of sigma_11
  /// Of a half cycle: a stress limit may lie beyond the strength.
  std::uint64_t most_steps = 2'000'000;

  /// Throws InvalidInput that names the value and the rule.
  [[nodiscard]] std::vector<LoadingStage<>> stages() const {
    require(lower < upper, "CyclicShear.lower", lower, "must be below upper");
    require(cycles > 0, "CyclicShear.cycles", cycles, "must be above 0");
    require_positive("CyclicShear.inertial_number", inertial_number);
    std::vector<LoadingStage<>> stages;
    for (int cycle = 1; cycle <= cycles; ++cycle)
      for (const bool up : {true, false}) stages.push_back(half_cycle(cycle, up));
    return stages;
  }

 private:
  [[nodiscard]] LoadingStage<> half_cycle(int cycle, bool up) const {
    const LoadingRate rate{.inertial_number = inertial_number};
    const double limit = up ? upper : lower;
    LoadingStage<> stage{
        .name = "cycle " + std::to_string(cycle) + (up ? ", loading" : ", unloading"),
        .axis_1 = ControlledStress{.stress = pressure,
                                   .control = {.expected_rate = rate, .tolerance = tolerance}},
        .axis_2 = EngineeringRate{.rate_of_strain = up ? rate : -rate},
        .record_every = record_every,
        .most_steps = most_steps};
    if (by_stress)
      stage.end = StressReached{.stress = limit, .of = StressOf::difference};
    else
      stage.end = StrainReached{.strain = limit};
    return stage;
  }
};

}  // namespace riprap
