// SPDX-License-Identifier: BSL-1.0
#pragma once
// The counterparts of the paper's figures, from charts and from the pictures of the first sample.

#include <string>
#include <vector>

#include "../report/document.hpp"
#include "../results/results.hpp"

namespace report {

struct Figure {
  int number = 0;
  std::string title;
  std::string text;
  std::vector<Pictures> rows;
};

// Figs 3 to 21. A picture that a run did not leave is missing, and the text says so.
std::vector<Figure> figures(const Results& results, const std::filesystem::path& folder);

}  // namespace report
