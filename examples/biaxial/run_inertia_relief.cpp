// Breakable particles, free in their stress analysis.

#include "run.hpp"

void run_with_inertia_relief(const Options& options) {
  run(options, breakable_model(options).support(riprap::InertiaRelief{}));
}
