// SPDX-License-Identifier: BSL-1.0
#pragma once
// Tables of the study as a whole: what it was made of, what came out, and how close to equilibrium
// it ran.

#include <filesystem>

#include "../results/results.hpp"
#include "document.hpp"

namespace report {

// Of a crack in rock [J/m^2]; granites and limestones have some 50 to 200 (G = K^2 / E with a
// toughness K of 1.5 to 3.5 MPa m^0.5 and E of 40 to 70 GPa).
inline constexpr double fracture_energy_per_area = 100;

// Table 1 of the paper and what the paper leaves open, with the values that a run was made with.
Table parameters_table(const Json& parameters);
// Means over the samples, in brackets the least and the largest.
Table results_table(const Results& results);
// Dimensionless numbers that tell whether the runs were quasi-static and the contacts stiff.
Table quality_table(const Results& results);

}  // namespace report
