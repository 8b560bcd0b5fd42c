// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/geometry/polygon_properties.hpp>
#include <riprap/geometry/prescribed_polygon.hpp>
#include <riprap/geometry/second_moments.hpp>
#include <riprap/geometry/shape_measures.hpp>

namespace riprap {

namespace internal {

/// At 1 corners might coincide.
inline constexpr double largest_unevenness = 0.95;

/// Random numbers that a polygon is made of: the rest follows from how uneven its angles are.
struct CornerAngles {
  double start;                // of the first corner [rad]
  std::vector<double> shares;  // of the circle, between a corner and the next [-]
  double direction;            // of the stretch [rad]

  CornerAngles(unsigned corners, Random& random) : start(random.uniform(0, 2 * std::numbers::pi)) {
    // Between points that are uniform on the circle distances are exponential.
    double sum = 0;
    for (unsigned k = 0; k < corners; ++k) {
      shares.push_back(-std::log(1 - random.uniform(0, 1)));
      sum += shares.back();
    }
    for (double& share : shares) share /= sum;
    direction = random.uniform(0, 2 * std::numbers::pi);
  }

  /// Of area 1, with its centroid at the origin.
  /// @param unevenness from 0, all angles equal, to 1, corners at uniform places
  [[nodiscard]] std::vector<Vec2> ring(double unevenness, double elongation) const {
    std::vector<Vec2> ring;
    double angle = start;
    for (const double share : shares) {
      ring.push_back(Rotation::from_angle(angle) * Vec2{1, 0});
      const double equal = 1 / static_cast<double>(shares.size());
      angle += 2 * std::numbers::pi * (equal + unevenness * (share - equal));
    }
    const AreaProperties raw = area_properties(ring);
    const SecondMoments m = second_moments(ring, raw.centroid);
    // The root of the matrix of moments, times a number: its inverse makes both moments equal.
    const double root = std::sqrt(m.xx * m.yy - m.xy * m.xy);
    const double xx = m.xx + root;
    const double yy = m.yy + root;
    const double scale = 1 / std::sqrt((xx * yy - m.xy * m.xy) * raw.area);
    const Rotation turn = Rotation::from_angle(direction);
    const double stretch = std::sqrt(elongation);
    for (Vec2& v : ring) {
      const Vec2 x = v - raw.centroid;
      const Vec2 even = scale * Vec2{yy * x.x() - m.xy * x.y(), xx * x.y() - m.xy * x.x()};
      v = turn * Vec2{stretch * even.x(), even.y() / stretch};
    }
    return ring;
  }
};

/// The unevenness for which a polygon has this angularity, where there is one that is allowed.
[[nodiscard]] inline std::optional<double> unevenness_for(const CornerAngles& angles,
                                                          double elongation, double wanted) {
  const auto excess = [&](double unevenness) {
    return riprap::angularity(ConvexPolygon(angles.ring(unevenness, elongation))) - wanted;
  };
  double low = 0;
  double high = largest_unevenness;
  const bool rises = excess(high) > 0;
  if ((excess(low) > 0) == rises) return std::nullopt;
  for (int step = 0; step < 32; ++step) {
    const double middle = 0.5 * (low + high);
    ((excess(middle) > 0) == rises ? high : low) = middle;
  }
  return low;
}

}  // namespace internal

RIPRAP_INLINE void PrescribedShape::validate() const {
  require(fewest_corners >= 3, "PrescribedShape.fewest_corners", fewest_corners,
          "must be 3 or more");
  require(most_corners >= fewest_corners && most_corners <= max_polygon_vertices,
          "PrescribedShape.most_corners", most_corners, "must lie between fewest_corners and 64");
  elongation.validate("PrescribedShape.elongation");
  require(elongation.low() >= 1 && elongation.high() <= 100, "PrescribedShape.elongation",
          elongation.low() >= 1 ? elongation.high() : elongation.low(), "must lie in [1, 100]");
  require(unevenness >= 0 && unevenness <= internal::largest_unevenness,
          "PrescribedShape.unevenness", unevenness, "must lie in [0, 0.95]");
  if (!angularity) return;
  angularity->validate("PrescribedShape.angularity");
  require(angularity->low() >= 2 * std::numbers::pi, "PrescribedShape.angularity",
          angularity->low(), "must be 2 pi or more");
}

RIPRAP_INLINE ConvexPolygon random_polygon(const PrescribedShape& shape, double equivalent_diameter,
                                           Random& random) {
  const unsigned corners = random.uniform_integer(shape.fewest_corners, shape.most_corners);
  const double elongation = shape.elongation(random);
  internal::CornerAngles angles(corners, random);
  std::optional<double> unevenness = shape.unevenness;
  if (shape.angularity) {
    const double wanted = (*shape.angularity)(random);
    unevenness = internal::unevenness_for(angles, elongation, wanted);
    for (int tries = 1; !unevenness; ++tries) {
      if (tries == 1000)
        throw InvalidInput("PrescribedShape.angularity: " + to_text(wanted) +
                           " rad: no polygon of 1,000 with " + std::to_string(corners) +
                           " corners and an elongation of " + to_text(elongation) + " has it");
      angles = internal::CornerAngles(corners, random);
      unevenness = internal::unevenness_for(angles, elongation, wanted);
    }
  }
  std::vector<Vec2> ring = angles.ring(*unevenness, elongation);
  const double size = std::sqrt(0.25 * std::numbers::pi) * equivalent_diameter;
  for (Vec2& v : ring) v = size * v;
  return ConvexPolygon(std::move(ring));
}

}  // namespace riprap
