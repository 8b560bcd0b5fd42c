// SPDX-License-Identifier: BSL-1.0
// The preset of the paper to the letter.

#include <riprap/simulation/presets/bagherzadeh_2008.hpp>

#include "run.hpp"

Outcome run_paper(const Options& options) {
  return run(options, preset_model(riprap::presets::bagherzadeh_2008(), options));
}
