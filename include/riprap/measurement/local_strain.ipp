// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>

#include <riprap/core/errors.hpp>
#include <riprap/geometry/delaunay.hpp>
#include <riprap/measurement/local_strain.hpp>

namespace riprap {

namespace internal {

inline void require_rising_ids(std::span<const MaterialPoint> points) {
  for (std::size_t k = 1; k < points.size(); ++k)
    require(points[k].id > points[k - 1].id, "local_strain: id of a point", points[k].id,
            "must be above that of the point before");
}

/// The points of two states that have one id.
struct CommonPoints {
  std::vector<ParticleId> ids{};
  std::vector<Vec2> positions{};      // in the reference state
  std::vector<Vec2> displacements{};  // from there
};

[[nodiscard]] inline CommonPoints common_points(std::span<const MaterialPoint> reference,
                                                std::span<const MaterialPoint> present) {
  require_rising_ids(reference);
  require_rising_ids(present);
  CommonPoints out;
  auto now = present.begin();
  for (const MaterialPoint& p : reference) {
    while (now != present.end() && now->id < p.id) ++now;
    if (now == present.end() || now->id != p.id) continue;
    out.ids.push_back(p.id);
    out.positions.push_back(p.position);
    out.displacements.push_back(now->position - p.position);
    require_finite("local_strain: displacement of a point",
                   out.displacements.back().x() + out.displacements.back().y());
  }
  return out;
}

}  // namespace internal

RIPRAP_INLINE std::vector<StrainTriangle> local_strain(std::span<const MaterialPoint> reference,
                                                       std::span<const MaterialPoint> present,
                                                       double least_height) {
  const internal::CommonPoints points = internal::common_points(reference, present);
  std::vector<StrainTriangle> out;
  for (const auto& [i, j, k] :
       without_flat_edge(delaunay(points.positions), points.positions, least_height)) {
    StrainTriangle t{.ids = {points.ids[i], points.ids[j], points.ids[k]}};
    t.corners = {points.positions[i], points.positions[j], points.positions[k]};
    t.gradient = displacement_gradient(
        t.corners, {points.displacements[i], points.displacements[j], points.displacements[k]});
    out.push_back(t);
  }
  return out;
}

RIPRAP_INLINE DisplacementGradient mean_gradient(std::span<const StrainTriangle> triangles) {
  DisplacementGradient sum;
  double area = 0;
  for (const StrainTriangle& t : triangles) {
    sum += t.area() * t.gradient;
    area += t.area();
  }
  return area == 0 ? sum : (1 / area) * sum;
}

RIPRAP_INLINE std::vector<PointGradient>
point_gradients(std::span<const StrainTriangle> triangles) {
  struct Share {
    ParticleId id;
    double area;
    DisplacementGradient gradient;
  };
  std::vector<Share> shares;
  for (const StrainTriangle& t : triangles)
    for (const ParticleId id : t.ids) shares.push_back({id, t.area(), t.gradient});
  std::stable_sort(shares.begin(), shares.end(),
                   [](const Share& p, const Share& q) { return p.id < q.id; });
  std::vector<PointGradient> out;
  for (auto first = shares.begin(); first != shares.end();) {
    PointGradient point{.id = first->id};
    double area = 0;
    for (; first != shares.end() && first->id == point.id; ++first) {
      point.gradient += first->area * first->gradient;
      area += first->area;
    }
    point.gradient = (1 / area) * point.gradient;
    out.push_back(point);
  }
  return out;
}

}  // namespace riprap
