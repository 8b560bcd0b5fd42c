// SPDX-License-Identifier: BSL-1.0
// The recommended preset.

#include <riprap/simulation/presets/recommended.hpp>

#include "run.hpp"

Outcome run_recommended(const Options& options) {
  return run(options, preset_model(riprap::presets::recommended(), options));
}
