// SPDX-License-Identifier: BSL-1.0
// Breakage by the contact loads alone; boundary: particles in a strain field.

#include "run.hpp"

Outcome run_loads_particles(const Options& options) {
  return run(options, model_by_loads(options).boundary(riprap::StrainField{}));
}
