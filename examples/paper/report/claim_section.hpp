// SPDX-License-Identifier: BSL-1.0
#pragma once
// How the report shows the claims: a summary of verdicts, and each claim under its figure.

#include <filesystem>
#include <string>
#include <vector>

#include "../claims/claims.hpp"
#include "document.hpp"

namespace report {

// A claim, or one that the study of unconfined tests has judged.
struct ShownClaim {
  int number = 0;
  Json json = {};  // as claims.json has it
  std::string section = {};
  std::string text = {};
  std::string rule = {};
  std::string quantity = {};
  std::string verdict = {};
  std::string reason = {};
  std::vector<int> figures = {};
  Table numbers = {};
};

// Judged by the runs, and taken from unconfined/unconfined.json where there is one.
std::vector<ShownClaim> shown_claims(const Results& results, const std::filesystem::path& folder);

// "Of 30 statements 12 hold, ...".
std::string count_text(const std::vector<ShownClaim>& claims);
Table summary_table(const std::vector<ShownClaim>& claims);
// The claims of a figure; those that an earlier figure has shown are only named.
void add_claims(Document& document, const std::vector<ShownClaim>& claims, int figure);

}  // namespace report
