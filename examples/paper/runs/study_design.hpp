// SPDX-License-Identifier: BSL-1.0
#pragma once
// The runs that make the study.

#include <vector>

#include "../options.hpp"
#include "plan.hpp"

namespace study {

// A variation of a series, at some of the pressures.
struct Row {
  Variation variation = Variation::none;
  Mode mode = Mode::wb;
  std::vector<double> pressures;  // [Pa]
  unsigned samples = 8;           // at most
};

// The series and its rows. Another row is another Variation, with what it does in RunPlan or in a
// run_NAME.cpp, and a line here.
std::vector<Row> study_rows(const Options& options);

// The longest first, so that none is left alone at the end.
std::vector<RunPlan> all_runs(const Options& options);

}  // namespace study
