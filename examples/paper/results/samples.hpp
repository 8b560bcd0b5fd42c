// SPDX-License-Identifier: BSL-1.0
#pragma once
// What several samples say together: means, their standard errors, and what a pooled test shows.

#include <cstddef>
#include <map>
#include <vector>

namespace report {

struct Estimate {
  double mean = 0;
  double standard_error = 0;  // of the mean; not a number for fewer than two samples
  std::size_t samples = 0;
};

// Not a number, in both, if any of the values is none.
Estimate estimate(const std::vector<double>& values);

// Pearson's coefficient of correlation. Zero where one of the two is constant.
double correlation(const std::vector<double>& x, const std::vector<double>& y);

// Every test is Student's, one-sided, at this level.
inline constexpr double test_level = 0.95;

// Does a statement "this is above 0" agree with the samples?
enum class Outcome { agrees, within_scatter, against };

// Agrees, or is against, where the mean differs from 0 by Student's one-sided test at the level
// (at 95 % by 1.895 standard errors for eight samples). Needs two samples.
Outcome outcome_above_zero(const Estimate& difference, double level = test_level);

// A quantity in one cell of the design, a series at a pressure, by the number of the sample.
using Cell = std::map<int, double>;

// A contrast of the cells, sum of weight times quantity, sample by sample: its mean and error over
// the samples that all cells have. The sample is the unit, so that what the cells of one sample
// have in common is no evidence counted several times.
Estimate pooled(const std::vector<Cell>& cells, const std::vector<double>& weights);

// Weights of the mean of all cells, and of the least-squares slope over x.
std::vector<double> mean_weights(std::size_t cells);
std::vector<double> slope_weights(const std::vector<double>& x);

// What a pooled test says of an effect that is claimed to be above 0. An effect of less than the
// margin counts as none; a margin of 0 sets no such limit.
enum class Shown {
  effect,        // above 0
  small_effect,  // above 0, and less than the margin
  neither,       // all is possible
  no_effect,     // less than the margin
  opposite       // below 0
};
Shown shown_by(const Estimate& effect, double margin);

// Probability of such a mean or a larger one where the effect is 0.
double p_value(const Estimate& effect);

}  // namespace report
