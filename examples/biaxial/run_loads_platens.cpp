// SPDX-License-Identifier: BSL-1.0
// Breakage by the contact loads alone; boundary: rigid platens.

#include "run.hpp"

Outcome run_loads_platens(const Options& options) {
  return run(options, model_by_loads(options).boundary(riprap::RigidPlatens{}));
}
