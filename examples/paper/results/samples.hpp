// SPDX-License-Identifier: BSL-1.0
#pragma once
// What several samples say together: means, their standard errors, and whether a difference is
// larger than the scatter.

#include <cstddef>
#include <vector>

namespace report {

struct Estimate {
  double mean = 0;
  double standard_error = 0;  // of the mean; not a number for fewer than two samples
  std::size_t samples = 0;
  std::size_t fitted = 1;  // samples less degrees of freedom
};

// Not a number, in both, if any of the values is none.
Estimate estimate(const std::vector<double>& values);

// Pearson's coefficient of correlation. Needs three pairs.
Estimate correlation(const std::vector<double>& x, const std::vector<double>& y);

// Does a statement "this is above 0" agree with the samples?
enum class Outcome { agrees, within_scatter, against };

// Agrees, or is against, where the mean differs from 0 by Student's one-sided test at 95 % (2.92
// standard errors for three samples). Needs two samples; a correlation, three.
Outcome outcome_above_zero(const Estimate& difference);

}  // namespace report
