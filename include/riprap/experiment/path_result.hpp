// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The result of a loading path.

#include <cstdint>
#include <vector>

#include <riprap/core/compiler.hpp>

namespace riprap {

/// What a stage leaves beside the observers' records.
struct StageResult {
  std::uint64_t steps = 0;
  double wall_seconds = 0;            ///< over all parts of a run that was stopped and went on
  std::uint64_t saturated_steps = 0;  ///< in which a servo's rate was at its limit
  /// False: the cap on its steps or a stop ended the stage, or it was not reached.
  bool reached_target = false;
  bool begun = false;
  double mean_error = 0;  ///< mean over its steps of stress / target - 1, where that is judged
  double rms_error = 0;
  /// stress / target - 1 of a held stress in its last step, judged or not; of two, the worse one; 0
  /// where the target is 0.
  double last_error = 0;

  static void for_each_field(auto& self, auto&& visit) {
    visit("steps", self.steps);
    visit("wall_seconds", self.wall_seconds);
    visit("saturated_steps", self.saturated_steps);
    visit("reached_target", self.reached_target);
    visit("begun", self.begun);
    visit("mean_error", self.mean_error);
    visit("rms_error", self.rms_error);
    visit("last_error", self.last_error);
  }
};

struct PathResult {
  std::vector<StageResult> stages;  ///< of the path, in order
  bool interrupted = false;         ///< an observer's stop_requested ended it
};

namespace internal {

/// In place of a run that does not compile.
struct NoRun {
  static constexpr struct Anything {
    template <class T>
    operator T() const {
      return {};
    }
  } anything{};
  [[nodiscard]] static bool advance() { return false; }
  [[nodiscard]] static Anything run() { return anything; }
};

}  // namespace internal

}  // namespace riprap
