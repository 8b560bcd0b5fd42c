// SPDX-License-Identifier: BSL-1.0
#pragma once
// Runs that differ from a series in one thing, to find out why eq. 14 departs from eq. 12 there.

#include <filesystem>

#include "../report/document.hpp"
#include "../results/results.hpp"

namespace report {

// The runs in FOLDER/causes beside their series: distances of eqs 14 and 15 and of the full
// relation from the measured sin phi, and by how much each run changes that of eq. 14, against the
// scatter of the samples. Without rows if there are no such runs.
Table causes_table(const Results& results, const std::filesystem::path& folder);

}  // namespace report
