// SPDX-License-Identifier: BSL-1.0
// Breakage by the contact loads alone; boundary: a periodic cell.

#include "run.hpp"

Outcome run_loads_periodic(const Options& options) {
  return run(options, model_by_loads(options).boundary(riprap::PeriodicCell{}));
}
