// SPDX-License-Identifier: BSL-1.0
#pragma once
// What the examples of shear tests compute from what they measured.

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include <riprap/core/stress2.hpp>
#include <riprap/core/vec2.hpp>
#include <riprap/measurement/regression_line.hpp>
#include <riprap/output/chart.hpp>

#include "../study/statistics.hpp"

namespace shear_tests {

// Keeps the order in which things are written.
using Json = nlohmann::ordered_json;

// Colours of the curves, one for each normal stress.
[[nodiscard]] std::string colour(std::size_t k);

// tau = cohesion + tan(angle) sigma by least squares, and the line through the origin.
struct Envelope {
  double cohesion = 0;      // [Pa]
  double angle = 0;         // of friction [degrees]; not-a-number for a single normal stress
  double secant_angle = 0;  // of the line through the origin [degrees]
};
// Points are (normal stress, shear stress) [Pa].
[[nodiscard]] Envelope envelope(const std::vector<riprap::Vec2>& points);

// A straight line through points, and the share of the scatter along y that it explains.
struct StraightLine {
  riprap::RegressionLine line{};
  double r_squared = 0;  // 1 where all points are on it
};
[[nodiscard]] StraightLine straight_line(const std::vector<riprap::Vec2>& points);

// The mean of several curves with the same abscissae; the shortest one sets how many points.
[[nodiscard]] std::vector<riprap::Vec2>
mean_curve(const std::vector<std::vector<riprap::Vec2>>& curves);

// Means of y over equal intervals of x between the ends, at the middles; intervals without points
// are left out.
[[nodiscard]] std::vector<riprap::Vec2> bin_means(const std::vector<riprap::Vec2>& points,
                                                  double low, double high, std::size_t bins);

// Direction of the major principal stress [degrees] from axis 1, in [0, 180).
[[nodiscard]] double major_direction(const riprap::Stress2& stress);
// That of the strain rate of simple shear dv_1/dx_2 > 0, with the shortening rate along axis 2 over
// the shear rate: 135 at constant volume.
[[nodiscard]] double major_direction_of_rate(double contraction);

// "0.61 -+ 0.03" for the 95 % interval of the mean, or the value alone of one sample.
[[nodiscard]] std::string interval_text(const run_study::Statistics& s, int decimals);
[[nodiscard]] Json to_json(const run_study::Statistics& s);

}  // namespace shear_tests
