#pragma once
// Four outcomes that a repetition of the study has to have, judged by the means of the samples
// alone, and the causes that were suspected and tried where one is missing.

#include <string>
#include <vector>

#include "document.hpp"
#include "results.hpp"

namespace report {

enum class Met { yes, no, not_judged };

struct Requirement {
  std::string text;
  std::string numbers;
  Met met = Met::not_judged;
};

std::vector<Requirement> requirements(const Results& results);

Table requirements_table(const std::vector<Requirement>& all);

// A list of {cause, runs, effect, scatter}, each a text, a number or a list of them; the names of
// the columns are those of the first entry.
Table causes_table(const Json& causes);

}  // namespace report
