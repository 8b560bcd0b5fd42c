// SPDX-License-Identifier: BSL-1.0
#pragma once
// The charts of Figs 12 and 14 to 21: means over the samples, with bars of one standard deviation.

#include <string>
#include <vector>

#include <riprap/output/chart.hpp>

#include "../results/results.hpp"

namespace report {

// (a) without and (b) with breakage: a column of the curve against axial strain at every pressure,
// all to one scale.
std::vector<riprap::Chart> pressure_charts(const Results& results, const std::string& column,
                                           const std::string& label, double factor);
// Fig. 15: the three anisotropies, with and without breakage, at 0.5, 4 and 14 MPa.
std::vector<riprap::Chart> anisotropy_charts(const Results& results);
// Fig. 20: sin phi by eqs 12 and 14 at 0.5 and 14 MPa; (a) without, (b) with breakage.
std::vector<riprap::Chart> fabric_charts(const Results& results);
// Fig. 21: sin phi by eqs 12, 14 and 15 at (a) 0.5 and (b) 14 MPa, with and without breakage.
std::vector<riprap::Chart> simplified_charts(const Results& results);

}  // namespace report
