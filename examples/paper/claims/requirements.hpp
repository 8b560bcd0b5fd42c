// SPDX-License-Identifier: BSL-1.0
#pragma once
// Four outcomes that a repetition of the study has to have, judged by the means of the samples
// alone.

#include <string>
#include <vector>

#include "../report/document.hpp"
#include "../results/results.hpp"

namespace report {

enum class Met { yes, no, not_judged };

struct Requirement {
  std::string text;
  std::string numbers;
  Met met = Met::not_judged;
};

std::vector<Requirement> requirements(const Results& results);

Table requirements_table(const std::vector<Requirement>& all);

}  // namespace report
