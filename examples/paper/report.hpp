#pragma once
// The report of a study.

#include <filesystem>

// Writes report.html, paper.md with its images, and claims.json into the folder of a study, from
// the runs that are in it.
void write_report(const std::filesystem::path& folder);
