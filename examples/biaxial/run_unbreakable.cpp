// SPDX-License-Identifier: BSL-1.0
// Particles that never break, with everything at its default: no stress analysis in the program.

#include "run.hpp"

Outcome run_without_breakage(const Options& options) {
  return run(options, breakable_model(options).criterion(riprap::NeverFails{}));
}
