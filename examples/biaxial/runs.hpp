// SPDX-License-Identifier: BSL-1.0
#pragma once
// The runs that the program has compiled in: one source file each. The defaults have two of their
// own and one that reads a clock, the presets one each; whether the plane is periodic, and whether
// particles are meshed, is decided at compile time.

#include "options.hpp"

enum class Outcome { finished, interrupted };

// Throw InvalidInput for parameters that break a rule, and SimulationError where a run cannot go
// on.
Outcome run_with_inertia_relief(const Options& options);
Outcome run_without_breakage(const Options& options);
Outcome run_timed(const Options& options);
Outcome run_recommended(const Options& options);
Outcome run_paper(const Options& options);
Outcome run_choices_particles(const Options& options);
Outcome run_choices_platens(const Options& options);
Outcome run_choices_periodic(const Options& options);
Outcome run_loads_particles(const Options& options);
Outcome run_loads_platens(const Options& options);
Outcome run_loads_periodic(const Options& options);
