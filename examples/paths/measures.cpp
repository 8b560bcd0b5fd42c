// SPDX-License-Identifier: BSL-1.0
#include "measures.hpp"

#include <cmath>

#include <riprap/core/errors.hpp>
#include <riprap/geometry/polygon_properties.hpp>

namespace paths {

Points stage_points(const Points& curve, std::size_t stage) {
  Points points;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (curve[i].stage_index != stage) continue;
    if (points.empty() && i > 0) points.push_back(curve[i - 1]);
    points.push_back(curve[i]);
  }
  return points;
}

riprap::CurvePoint stage_end(const Points& curve, std::size_t stage) {
  const Points points = stage_points(curve, stage);
  riprap::require(!points.empty(), "stage_end: stage", static_cast<double>(stage),
                  "must have points");
  return points.back();
}

double stress_work(const Points& points) {
  const auto lateral = [](const riprap::CurvePoint& p) {
    return (1 - p.volumetric_strain) / (1 - p.axial_strain);  // length over that at zero strain
  };
  double work = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const riprap::CurvePoint& p = points[i - 1];
    const riprap::CurvePoint& q = points[i];
    const double e_1 = std::log(lateral(p) / lateral(q));
    const double e_2 = std::log((1 - p.axial_strain) / (1 - q.axial_strain));
    work += 0.5 * ((1 - p.volumetric_strain) * (p.stress.s11 * e_1 + p.stress.s22 * e_2) +
                   (1 - q.volumetric_strain) * (q.stress.s11 * e_1 + q.stress.s22 * e_2));
  }
  return work;
}

double loop_area(std::span<const riprap::Vec2> strain_and_stress) {
  return -riprap::polygon_area(strain_and_stress);
}

double secant(const riprap::Vec2& from, const riprap::Vec2& to) {
  return (to.y() - from.y()) / (to.x() - from.x());
}

}  // namespace paths
