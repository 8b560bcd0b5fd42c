// SPDX-License-Identifier: BSL-1.0
#pragma once
// Single numbers read from the curve of a run. Strains are shares, not per cent.

#include <string>

#include "results.hpp"

namespace report {

// Mean over the records between two axial strains, both included.
double mean_between(const Run& run, const std::string& column, double from, double to);
// The first record: the end of the hydrostatic stage.
double at_start(const Run& run, const std::string& column);
// Over the last 5 % of strain.
double at_end(const Run& run, const std::string& column);
double largest(const Run& run, const std::string& column);

// The largest value, and the strain where it stands, of the column averaged over 2 % of strain: a
// single record scatters too much to tell where a flat top has its middle.
struct Peak {
  double value = 0;
  double strain = 0;
};
Peak smooth_peak(const Run& run, const std::string& column);
// The first strain at which the smoothed column has a share of its peak.
double strain_at_share_of_peak(const Run& run, const std::string& column, double share);
// Share of the smoothed peak that is lost by the last 5 % of strain; 0 where it stands there.
double loss_after_peak(const Run& run, const std::string& column);

// Mean distance of a prediction of sin phi from the measured one, from 1 % of strain on: before it
// both are close to 0.
double mean_gap(const Run& run, const std::string& prediction);

}  // namespace report
