// SPDX-License-Identifier: BSL-1.0
// Contact law, integrator and support chosen at run time; boundary: a periodic cell.

#include "run.hpp"

Outcome run_choices_periodic(const Options& options) {
  return run(options, model_of_choices(options).boundary(riprap::PeriodicCell{}));
}
