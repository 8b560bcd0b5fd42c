// SPDX-License-Identifier: BSL-1.0
#pragma once
// The report of a study, from the files of its runs alone.

#include <filesystem>

// Reads FOLDER/runs/*/run.json with their pictures and, where they are there, FOLDER/unconfined and
// FOLDER/causes/*/run.json; writes report.html (self-contained), paper.md with images/paper/*.svg,
// and claims.json. Throws riprap::InvalidInput if there is no finished run or a file is malformed,
// and riprap::SimulationError if a file cannot be written.
void write_report(const std::filesystem::path& folder);
