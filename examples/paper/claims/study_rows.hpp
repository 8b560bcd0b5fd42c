// SPDX-License-Identifier: BSL-1.0
#pragma once
// The rows of the study: runs that differ from a series in one thing, beside it.

#include "../report/document.hpp"
#include "../results/results.hpp"

namespace report {

// Means over the samples of every row and of the series it belongs to. Without rows if there are no
// such runs.
Table rows_table(const Results& results);

// What a row changes, sample by sample: means and standard errors, bold where Student's two-sided
// test has a change with 95 %.
Table row_changes_table(const Results& results);

// How much of the fall of the largest sin phi with pressure is there without breakage, and how much
// with contacts four times stiffer; "" if runs are missing.
std::string softness_text(const Results& results);

}  // namespace report
