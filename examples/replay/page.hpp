// SPDX-License-Identifier: BSL-1.0
#pragma once
// The page: HTML, style, program and data in one text.

#include <string>

#include "recorded_run.hpp"

namespace replay {

// @param title what the run is called
std::string page_of(const RecordedRun& run, const std::string& title);

}  // namespace replay
