// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The oedometer test: compression without lateral strain.

#include <cstdint>
#include <string>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/experiment/loading_stage.hpp>

namespace riprap {

/// Axis 1 is fixed, and axis 2 is strained to one vertical stress after the other, where a lower
/// one unloads. K0 is sigma_11 / sigma_22.
struct Oedometer {
  std::vector<double> vertical_stresses{4e6, 8e6, 16e6, 2e6};  ///< [Pa]
  double inertial_number = 1e-3;                               ///< at the path's confining pressure
  double record_every = 0.001;                                 ///< axial strain between records [-]
  std::uint64_t most_steps = 5'000'000;                        ///< of a stage

  /// From the vertical stress at the start [Pa]. Throws InvalidInput that names value and rule.
  [[nodiscard]] std::vector<LoadingStage<>> stages(double from) const {
    require_positive("Oedometer.inertial_number", inertial_number);
    std::vector<LoadingStage<>> stages;
    for (const double stress : vertical_stresses) {
      require_positive("Oedometer.vertical_stresses", stress);
      const LoadingRate rate{.inertial_number = inertial_number};
      stages.push_back(
          {.name = (stress < from ? "unloading to " : "loading to ") + to_text(stress) + " Pa",
           .axis_2 = EngineeringRate{.rate_of_strain = stress < from ? -rate : rate},
           .end = StressReached{.stress = stress, .of = StressOf::axis_2},
           .record_every = record_every,
           .most_steps = most_steps});
      from = stress;
    }
    return stages;
  }
};

}  // namespace riprap
