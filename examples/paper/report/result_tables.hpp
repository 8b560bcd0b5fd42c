// SPDX-License-Identifier: BSL-1.0
#pragma once
// Tables of the study as a whole: what it was made of, what came out, and how close to equilibrium
// it ran.

#include <filesystem>

#include "../results/results.hpp"
#include "document.hpp"

namespace report {

// Table 1 of the paper and what the paper leaves open, with the values that a run was made with.
Table parameters_table(const Json& parameters);
// Means over the samples, in brackets the least and the largest.
Table results_table(const Results& results);
// Dimensionless numbers that tell whether the runs were quasi-static and the contacts stiff.
Table quality_table(const Results& results);

}  // namespace report
