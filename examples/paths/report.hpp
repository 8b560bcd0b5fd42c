// SPDX-License-Identifier: BSL-1.0
#pragma once
// What the reports of all tests are made of.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <riprap/output/chart.hpp>

#include "measures.hpp"
#include "test_case.hpp"

namespace paths {

inline constexpr auto blue = "#1f6fb4";
inline constexpr auto orange = "#d9661f";
inline constexpr auto green = "#15803d";
inline constexpr auto purple = "#8e44ad";
inline constexpr auto grey = "#777777";

// The stages of preparation come first in every path.
inline constexpr std::size_t first_stage = 3;

// One run for each sample; the folder has `variant` in its name.
void add_runs(std::vector<PlannedRun>& runs, const Options& o, const PlannedRun& of_all);

// The runs of a variant, in the order of the seeds.
std::vector<const Run*> runs_of(const std::vector<Run>& runs, std::string_view variant);

using Value = std::function<double(const riprap::CurvePoint&)>;
double in_per_cent(double share);
double in_mpa(double stress);

// A curve of a run.
riprap::Series curve(const Run& run, const Value& x, const Value& y, const std::string& colour);
// A curve for each run of a variant, of one colour; the legend has the first.
void add_curves(riprap::Chart& chart, const std::vector<Run>& runs, std::string_view variant,
                const std::string& name, const std::string& colour, const Value& x, const Value& y);
// The same of a number that goes with each point of the curve.
void add_curves(riprap::Chart& chart, const std::vector<Run>& runs, std::string_view variant,
                const std::string& name, const std::string& colour, const Value& x,
                const std::vector<double> Run::*y);
// A chart of these.
riprap::Chart chart(const std::string& title, const std::string& x, const std::string& y);

// A number of each sample: values, their mean, and half of the 95 % interval of the mean by
// Student's t, which is null for less than two samples.
Json spread(const std::vector<double>& values);
// "0.049 +- 0.003" or "0.049" for one sample, with a unit; how many have a number, if not all.
std::string spread_text(const std::vector<double>& values, double factor = 1,
                        const std::string& unit = "");

}  // namespace paths
