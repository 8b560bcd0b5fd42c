// SPDX-License-Identifier: BSL-1.0
#pragma once
// Numbers of a curve that has several stages.

#include <cstddef>
#include <span>
#include <vector>

#include <riprap/core/vec2.hpp>
#include <riprap/experiment/curve.hpp>

namespace paths {

using Points = std::vector<riprap::CurvePoint>;

// sigma_22 - sigma_11 [Pa].
[[nodiscard]] inline double difference(const riprap::CurvePoint& p) {
  return p.stress.s22 - p.stress.s11;
}

// The points of a stage, by its place in the path, and the last one before them where there is
// one: from end to end. None where the stage has no points.
[[nodiscard]] Points stage_points(const Points& curve, std::size_t stage);
// The last one of a stage, which has points.
[[nodiscard]] riprap::CurvePoint stage_end(const Points& curve, std::size_t stage);

// Work of the stresses on the sample from the first point to the last, over its volume at zero
// strain [J/m^3]: the integral of (1 - volumetric strain) (sigma_11 d e_1 + sigma_22 d e_2) with
// logarithmic strains e, by the trapezoidal rule.
[[nodiscard]] double stress_work(const Points& points);

// Area of a loop of stress against strain [Pa], positive where it is run through clockwise, with
// loading above unloading: what a cycle dissipates per volume. Its ends are joined by a straight
// line.
[[nodiscard]] double loop_area(std::span<const riprap::Vec2> strain_and_stress);

// Slope of the line between two points of a curve of stress against strain [Pa].
[[nodiscard]] double secant(const riprap::Vec2& from, const riprap::Vec2& to);

}  // namespace paths
