// SPDX-License-Identifier: BSL-1.0
// Contact law, integrator and support chosen at run time; boundary: a periodic cell.

#include "run.hpp"

void run_choices_periodic(const Options& options) {
  run(options, model_of_choices(options).boundary(riprap::PeriodicCell{}));
}
