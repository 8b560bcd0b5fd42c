// SPDX-License-Identifier: BSL-1.0
#pragma once
// A run as the page reads it: numbers that are looked up by name, and arrays in few bytes.

#include <nlohmann/json.hpp>

#include "binary.hpp"
#include "recorded_run.hpp"

namespace replay {

struct PackedRun {
  nlohmann::ordered_json head{};
  Binary arrays{};
};

// Throws InvalidInput if a frame has more particles than 16 bits can number.
PackedRun pack(const RecordedRun& run);

}  // namespace replay
