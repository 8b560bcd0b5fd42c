// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The result of a biaxial test.

#include <array>
#include <cstddef>

#include <riprap/experiment/path_result.hpp>
#include <riprap/experiment/stage.hpp>

namespace riprap {

/// What a biaxial test leaves beside the observers' records.
struct BiaxialResult {
  using StageResult = riprap::StageResult;
  std::array<StageResult, 4> stages;  ///< in the order of Stage
  bool interrupted = false;           ///< an observer's stop_requested ended the test
  double axial_rate = 0;              ///< of shear [1/s]
  double mean_confinement_error = 0;  ///< mean over all steps of shear of sigma_11 / pressure - 1
  double rms_confinement_error = 0;

  [[nodiscard]] const StageResult& stage(Stage s) const {
    return stages[static_cast<std::size_t>(s)];
  }
};

}  // namespace riprap
