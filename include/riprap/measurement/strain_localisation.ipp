// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/measurement/fabric.hpp>
#include <riprap/measurement/strain_localisation.hpp>

namespace riprap {

namespace internal {

/// Parts of the triangles of largest strain that make up `area`, with 0 for those outside.
[[nodiscard]] inline std::vector<double>
parts_of_most_strained(std::span<const StrainTriangle> triangles,
                       const std::vector<double>& strains, double area) {
  std::vector<std::size_t> order(triangles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return strains[i] > strains[j]; });
  std::vector<double> parts(triangles.size(), 0);
  for (const std::size_t n : order) {
    if (area <= 0) break;
    parts[n] = std::min(1.0, area / triangles[n].area());
    area -= triangles[n].area();
  }
  return parts;
}

/// The weights of the connected part with the largest sum, and 0 for all others.
[[nodiscard]] inline std::vector<double>
largest_connected_part(std::span<const StrainTriangle> triangles,
                       const std::vector<double>& weights) {
  std::vector<std::size_t> leader(triangles.size());
  std::iota(leader.begin(), leader.end(), std::size_t{0});
  const auto leader_of = [&](std::size_t n) {
    while (leader[n] != n) n = leader[n] = leader[leader[n]];
    return n;
  };
  std::map<ParticleId, std::size_t> at_corner;
  for (std::size_t n = 0; n < triangles.size(); ++n) {
    if (weights[n] == 0) continue;
    for (const ParticleId id : triangles[n].ids)
      leader[leader_of(at_corner.try_emplace(id, n).first->second)] = leader_of(n);
  }
  std::vector<double> sums(triangles.size(), 0);
  for (std::size_t n = 0; n < triangles.size(); ++n) sums[leader_of(n)] += weights[n];
  const auto largest =
      static_cast<std::size_t>(std::max_element(sums.begin(), sums.end()) - sums.begin());
  std::vector<double> out(triangles.size(), 0);
  for (std::size_t n = 0; n < triangles.size(); ++n)
    if (leader_of(n) == largest) out[n] = weights[n];
  return out;
}

/// Second moments of the triangles with weights, about their common centroid; fills the band.
inline void set_band(StrainLocalisation& out, std::span<const StrainTriangle> triangles,
                     const std::vector<double>& weights) {
  double sum = 0;
  for (std::size_t n = 0; n < triangles.size(); ++n) {
    sum += weights[n];
    out.centre += weights[n] * triangles[n].centroid();
  }
  out.centre = out.centre / sum;
  Deviator deviator;
  double trace = 0;
  for (std::size_t n = 0; n < triangles.size(); ++n) {
    const Vec2 centroid = triangles[n].centroid();
    const auto add = [&](double weight, const Vec2& v) {
      deviator.add(weight, v, v);
      trace += weight * v.dot(v);
    };
    add(weights[n], centroid - out.centre);
    // Of a triangle about its own centroid: a twelfth of the sum over its corners.
    for (const Vec2& corner : triangles[n].corners) add(weights[n] / 12, corner - centroid);
  }
  const double radius = std::hypot(deviator.half_difference, deviator.shear);
  const double major = (0.5 * trace + radius) / sum;
  const double minor = std::max(0.0, (0.5 * trace - radius) / sum);
  out.direction = radius == 0 ? 0 : 0.5 * std::atan2(deviator.shear, deviator.half_difference);
  out.elongation = minor > 0 ? std::sqrt(major / minor) : std::numeric_limits<double>::infinity();
  out.thickness = std::sqrt(12 * minor);
}

}  // namespace internal

RIPRAP_INLINE StrainLocalisation strain_localisation(std::span<const StrainTriangle> triangles,
                                                     double area_share) {
  require(area_share > 0 && area_share <= 1, "strain_localisation: area_share", area_share,
          "must lie in (0, 1]");
  std::vector<double> strains;
  double area = 0;
  double sum = 0;
  double squares = 0;
  for (const StrainTriangle& t : triangles) {
    const double g = t.gradient.deviatoric_strain();
    strains.push_back(g);
    area += t.area();
    sum += t.area() * g;
    squares += t.area() * g * g;
  }
  StrainLocalisation out;
  if (!(sum > 0)) return out;
  out.participation_ratio = sum * (sum / area) / squares;
  std::vector<double> weights =
      internal::parts_of_most_strained(triangles, strains, area_share * area);
  for (std::size_t n = 0; n < triangles.size(); ++n) {
    weights[n] *= triangles[n].area() * strains[n];
    out.strain_share += weights[n] / sum;
  }
  const std::vector<double> band = internal::largest_connected_part(triangles, weights);
  for (const double weight : band) out.band_share += weight / sum;
  internal::set_band(out, triangles, band);
  return out;
}

}  // namespace riprap
