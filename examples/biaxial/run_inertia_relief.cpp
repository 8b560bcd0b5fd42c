// SPDX-License-Identifier: BSL-1.0
// Breakable particles, free in their stress analysis, with everything at its default.

#include "run.hpp"

Outcome run_with_inertia_relief(const Options& options) {
  return run(options, breakable_model(options));
}
