// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Points of a sample by which two of its states are compared.

#include <algorithm>
#include <utility>
#include <vector>

#include <riprap/core/vec2.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// A point that can be found again in another state.
struct MaterialPoint {
  ParticleId id = 0;
  Vec2 position{0, 0};  ///< [m]

  static void for_each_field(auto& self, auto&& visit) {
    visit("id", self.id);
    visit("position", self.position);
  }
};

/// Centroids of all particles by their ids, in rising order; without walls and platens, whose
/// centroids are no part of the sample. Pieces have ids of their own: a particle that broke between
/// two states has no point in common.
[[nodiscard]] inline std::vector<MaterialPoint> centroids(const Particles& particles) {
  std::vector<MaterialPoint> out;
  for (BodyIndex i = 0; i < particles.size(); ++i)
    if (!particles.body(i).is_wall())
      out.push_back({particles.ancestry(i).id, particles.body(i).position});
  std::sort(out.begin(), out.end(), [](const auto& p, const auto& q) { return p.id < q.id; });
  return out;
}

/// A part of a material point.
struct PointPart {
  MaterialPoint point;
  double area = 0;  ///< [m^2]
};

/// One point for all parts of one id, in rising order: their mean, weighted by area.
[[nodiscard]] inline std::vector<MaterialPoint> joined_points(std::vector<PointPart> parts) {
  std::stable_sort(parts.begin(), parts.end(),
                   [](const PointPart& p, const PointPart& q) { return p.point.id < q.point.id; });
  std::vector<MaterialPoint> out;
  double area = 0;  // of the parts so far
  for (const auto& [point, part_area] : parts) {
    if (out.empty() || out.back().id != point.id) {
      out.push_back(point);
      area = part_area;
      continue;
    }
    area += part_area;
    Vec2& mean = out.back().position;
    mean += (part_area / area) * (point.position - mean);
  }
  return out;
}

/// The same as centroids() with one point for all pieces of an intact particle, by its id (`root`):
/// their common centroid, which does not jump when the particle breaks, but by what becomes dust.
[[nodiscard]] inline std::vector<MaterialPoint> root_centroids(const Particles& particles) {
  std::vector<PointPart> parts;
  for (BodyIndex i = 0; i < particles.size(); ++i)
    if (!particles.body(i).is_wall())
      parts.push_back(
          {{particles.ancestry(i).root, particles.body(i).position}, particles.shape(i).area});
  return joined_points(std::move(parts));
}

}  // namespace riprap
