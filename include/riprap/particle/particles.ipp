// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include <riprap/particle/particles.hpp>

namespace riprap {

RIPRAP_INLINE BodyIndex Particles::add(const ConvexPolygon& polygon, Motion motion,
                                       const Ancestry* parent, MaterialIndex material) {
  const auto index = static_cast<BodyIndex>(bodies_.size());
  const Ancestry copy = parent ? *parent : Ancestry{};  // *parent may lie in ancestries_
  bodies_.emplace_back();
  shapes_.emplace_back();
  ancestries_.emplace_back();
  materials_.push_back(material);
  place(index, polygon, motion, parent ? &copy : nullptr);
  return index;
}

RIPRAP_INLINE void Particles::replace(BodyIndex index, const ConvexPolygon& polygon, Motion motion,
                                      const Ancestry& parent) {
  const Ancestry copy = parent;
  dead_vertices_ += shapes_[index].count;
  place(index, polygon, motion, &copy);
  if (dead_vertices_ > local_.size() / 2) compact();
}

RIPRAP_INLINE void Particles::remove(BodyIndex i) {
  dead_vertices_ += shapes_[i].count;
  const auto at = static_cast<std::ptrdiff_t>(i);
  bodies_.erase(bodies_.begin() + at);
  shapes_.erase(shapes_.begin() + at);
  ancestries_.erase(ancestries_.begin() + at);
  materials_.erase(materials_.begin() + at);
  if (dead_vertices_ > local_.size() / 2) compact();
}

RIPRAP_INLINE std::optional<BodyIndex> Particles::find(ParticleId id) const {
  const auto found = std::ranges::find(ancestries_, id, &Ancestry::id);
  if (found == ancestries_.end()) return std::nullopt;
  return static_cast<BodyIndex>(found - ancestries_.begin());
}

RIPRAP_INLINE double Particles::mean_density() const {
  if (densities_.size() == 1) return densities_.front();
  const auto mean = [this](bool walls) {
    double mass = 0;
    double volume = 0;
    double least = std::numeric_limits<double>::infinity();
    double most = 0;
    for (BodyIndex i = 0; i < size(); ++i) {
      if (bodies_[i].is_wall() != walls) continue;
      mass += bodies_[i].mass;
      volume += thickness_ * shapes_[i].area;
      least = std::min(least, density(i));
      most = std::max(most, density(i));
    }
    if (least == most) return least;  // to the last bit
    return volume > 0 ? mass / volume : 0;
  };
  const double of_grains = mean(false);
  return of_grains > 0 ? of_grains : mean(true);
}

RIPRAP_INLINE void Particles::place(BodyIndex index, const ConvexPolygon& polygon, Motion motion,
                                    const Ancestry* parent) {
  const AreaProperties properties = area_properties(polygon.ring());
  Body body;
  body.position = properties.centroid;
  body.mass = density(index) * thickness_ * properties.area;
  body.inertia = density(index) * thickness_ * properties.polar_moment;
  body.motion = motion;
  bodies_[index] = body;

  ParticleShape shape{.area = properties.area,
                      .first = static_cast<std::uint32_t>(local_.size()),
                      .count = static_cast<std::uint32_t>(polygon.size())};
  for (const Vec2& v : polygon) {
    local_.push_back(v - properties.centroid);
    shape.circumradius = std::max(shape.circumradius, local_.back().norm());
  }
  shapes_[index] = shape;
  placed_.resize(local_.size());
  update_ring(index);

  Ancestry& ancestry = ancestries_[index];
  ancestry = {.id = next_id_++};
  ancestry.parent = parent ? parent->id : no_particle;
  ancestry.root = parent ? parent->root : ancestry.id;
  ancestry.generation = parent ? parent->generation + 1 : 0;
}

RIPRAP_INLINE void Particles::compact() {
  std::vector<Vec2> local;
  std::vector<Vec2> placed;
  for (ParticleShape& shape : shapes_) {
    const auto first = static_cast<std::uint32_t>(local.size());
    for (std::uint32_t k = shape.first; k < shape.first + shape.count; ++k) {
      local.push_back(local_[k]);
      placed.push_back(placed_[k]);
    }
    shape.first = first;
  }
  local_ = std::move(local);
  placed_ = std::move(placed);
  dead_vertices_ = 0;
}

}  // namespace riprap
