// SPDX-License-Identifier: BSL-1.0
// Breakable particles, free in their stress analysis, with everything at its default.

#include "run.hpp"

void run_with_inertia_relief(const Options& options) { run(options, breakable_model(options)); }
