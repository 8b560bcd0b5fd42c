// SPDX-License-Identifier: BSL-1.0
// Contact law, integrator and support chosen at run time; boundary: rigid platens.

#include "run.hpp"

Outcome run_choices_platens(const Options& options) {
  return run(options, model_of_choices(options).boundary(riprap::RigidPlatens{}));
}
