// SPDX-License-Identifier: BSL-1.0
#pragma once
// Makes the runs of a study, each by the biaxial example as a process of its own.

#include <filesystem>
#include <string>
#include <vector>

#include "runs.hpp"

namespace run_study {

struct Making {
  std::filesystem::path folder;   // of the study
  std::filesystem::path program;  // the biaxial example
  unsigned jobs = 1;
  unsigned threads = 1;                // of a run
  std::uint64_t checkpoint_every = 0;  // steps; 0 for no checkpoints
  bool retry = false;                  // what has failed
  bool take_over = false;              // locks of other machines
};

struct Outcome {
  std::size_t kept = 0;      // finished before
  std::size_t finished = 0;  // just now
  std::size_t unfinished = 0;
  std::size_t elsewhere = 0;  // that others are making
  std::size_t failed = 0;     // now or before
};

// Says on the standard error how far it is. SIGINT, SIGTERM and SIGUSR1 are passed on to the runs,
// SIGUSR1 with a SIGTERM behind it; they end at the end of a step and stay to be gone on with.
Outcome make_runs(const std::vector<Run>& runs, const Making& making);

}  // namespace run_study
