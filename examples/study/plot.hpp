// SPDX-License-Identifier: BSL-1.0
#pragma once
// A result over a parameter: every run a point, the mean of each combination with its 95 %
// interval.

#include <string>
#include <vector>

#include <riprap/output/chart.hpp>

#include "combinations.hpp"

namespace run_study {

struct Plot {
  std::string y;                 // a result
  std::string x;                 // an option with numbers, or a result
  std::string group{};           // an option or "row", a curve for each of its values; or none
  std::vector<Against> where{};  // options with the value that is shown
  bool log_x = false;            // x on a logarithmic axis
};
// From "Y:X" or "Y:X:GROUP", and "OPTION=VALUE" each. Throws riprap::InvalidInput.
Plot plot_from(const std::string& text, const std::vector<std::string>& where);

// Throws riprap::InvalidInput for names that there are not.
void check_plot(const Plot& plot, const Study& study);

// Throws riprap::InvalidInput for an x that is no number or, on a logarithmic axis, not above 0,
// and if two combinations of a curve have the same x.
riprap::Chart chart_of(const Plot& plot, const Study& study, const std::vector<Combination>& all);

// "breakages_pressure_contact.svg"
std::string file_name(const Plot& plot);

}  // namespace run_study
