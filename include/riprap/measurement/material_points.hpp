// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Points of a sample by which two of its states are compared.

#include <algorithm>
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

/// The same with one point for all pieces of an intact particle, by its id (`root`): their common
/// centroid, which does not jump when the particle breaks, but by what becomes dust.
[[nodiscard]] inline std::vector<MaterialPoint> root_centroids(const Particles& particles) {
  std::vector<BodyIndex> order;
  for (BodyIndex i = 0; i < particles.size(); ++i)
    if (!particles.body(i).is_wall()) order.push_back(i);
  std::sort(order.begin(), order.end(), [&](BodyIndex i, BodyIndex j) {
    const Ancestry& a = particles.ancestry(i);
    const Ancestry& b = particles.ancestry(j);
    return a.root != b.root ? a.root < b.root : a.id < b.id;
  });
  std::vector<MaterialPoint> out;
  double area = 0;  // of the pieces so far
  for (const BodyIndex i : order) {
    const ParticleId root = particles.ancestry(i).root;
    const double piece = particles.shape(i).area;
    const Vec2& position = particles.body(i).position;
    if (out.empty() || out.back().id != root) {
      out.push_back({root, position});
      area = piece;
      continue;
    }
    area += piece;
    Vec2& mean = out.back().position;
    mean += (piece / area) * (position - mean);
  }
  return out;
}

}  // namespace riprap
