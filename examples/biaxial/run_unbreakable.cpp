// SPDX-License-Identifier: BSL-1.0
// Particles that never break, with everything at its default: no stress analysis in the program.

#include "run.hpp"

void run_without_breakage(const Options& options) {
  run(options, breakable_model(options).criterion(riprap::NeverFails{}));
}
