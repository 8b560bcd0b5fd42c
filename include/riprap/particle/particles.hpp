// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The particles of a running simulation, stored for the hot loops.

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <riprap/core/ids.hpp>
#include <riprap/core/linkage.hpp>
#include <riprap/geometry/convex_polygon.hpp>
#include <riprap/particle/ancestry.hpp>
#include <riprap/particle/body.hpp>
#include <riprap/particle/dust.hpp>

namespace riprap {

/// Constant properties of a particle.
struct ParticleShape {
  double area = 0;          ///< [m^2]
  double circumradius = 0;  ///< farthest vertex from the centroid [m]
  std::uint32_t first = 0;  ///< of its vertices in the pools
  std::uint32_t count = 0;

  static void for_each_field(auto& self, auto&& visit) {
    visit("area", self.area);
    visit("circumradius", self.circumradius);
    visit("first", self.first);
    visit("count", self.count);
  }
};

/// Bodies, shapes and ancestry side by side, index by index; vertices of all particles in two
/// contiguous pools, one in body frames and one in the laboratory's.
class Particles {
 public:
  /// Of one material [m, kg/m^3].
  Particles(double thickness, double density)
      : Particles(thickness, std::vector<double>{density}) {}
  /// @param densities of the materials [kg/m^3]
  Particles(double thickness, std::vector<double> densities)
      : thickness_(thickness), densities_(std::move(densities)) {}

  [[nodiscard]] std::size_t size() const { return bodies_.size(); }
  [[nodiscard]] double thickness() const { return thickness_; }  ///< [m]
  /// Of particle i [kg/m^3].
  [[nodiscard]] double density(BodyIndex i) const { return densities_[materials_[i]]; }
  [[nodiscard]] MaterialIndex material(BodyIndex i) const { return materials_[i]; }
  /// Density of a material over that of another [-]: exactly 1 where the two are equal.
  [[nodiscard]] double density_ratio(MaterialIndex material, MaterialIndex other) const {
    return densities_[material] / densities_[other];
  }
  /// Number of materials.
  [[nodiscard]] std::size_t materials() const { return densities_.size(); }
  /// Mass over volume of all bodies but walls and platens, of all where there are no others
  /// [kg/m^3]; where they have one density it is that, to the last bit.
  [[nodiscard]] double mean_density() const;

  [[nodiscard]] const std::vector<Body>& bodies() const { return bodies_; }
  [[nodiscard]] std::vector<Body>& bodies() { return bodies_; }
  [[nodiscard]] const Body& body(BodyIndex i) const { return bodies_[i]; }
  [[nodiscard]] Body& body(BodyIndex i) { return bodies_[i]; }
  [[nodiscard]] const ParticleShape& shape(BodyIndex i) const { return shapes_[i]; }
  [[nodiscard]] const Ancestry& ancestry(BodyIndex i) const { return ancestries_[i]; }

  /// Vertices in the laboratory frame: those of the body's own, moved to its pose. A function of
  /// the two from the start, so that the vertices of an added polygon may differ from it by
  /// round-off.
  [[nodiscard]] Ring ring(BodyIndex i) const {
    return {placed_.data() + shapes_[i].first, shapes_[i].count};
  }
  /// Vertices in the body's own frame, centroid at the origin.
  [[nodiscard]] Ring local_ring(BodyIndex i) const {
    return {local_.data() + shapes_[i].first, shapes_[i].count};
  }

  /// Adds a particle at rest in its present place, with a new id.
  /// @param polygon in laboratory coordinates [m]
  /// @param parent  ancestry of the particle it broke from; null for an intact particle
  /// @param material below `materials()`
  BodyIndex add(const ConvexPolygon& polygon, Motion motion, const Ancestry* parent = nullptr,
                MaterialIndex material = 0);

  /// Puts a new particle, with a new id and the same material, where a broken one was stored.
  void replace(BodyIndex index, const ConvexPolygon& polygon, Motion motion,
               const Ancestry& parent);

  /// Takes particle i away; those behind it move up, in their order. Ids are not used again.
  void remove(BodyIndex i);
  /// Makes an intact particle a part of one with another root, as the cells of a cluster are.
  void set_root(BodyIndex i, ParticleId root) { ancestries_[i].root = root; }
  /// Where the particle with an id is; none, if it has broken or was removed.
  [[nodiscard]] std::optional<BodyIndex> find(ParticleId id) const;

  /// Counts a piece of `area` [m^2] of a particle that breaks, which is not simulated.
  void add_dust(const Ancestry& parent, double area, MaterialIndex material = 0) {
    dust_.push_back({parent.root, area, material});
  }
  [[nodiscard]] const std::vector<DustPiece>& dust() const { return dust_; }
  [[nodiscard]] double dust_area() const {  ///< [m^2]
    double sum = 0;
    for (const DustPiece& piece : dust_) sum += piece.area;
    return sum;
  }

  /// Brings the laboratory vertices of particle i to its pose.
  void update_ring(BodyIndex i) {
    // Local copies exclude aliasing with the vertices.
    const Rotation rotation = bodies_[i].rotation;
    const Vec2 position = bodies_[i].position;
    const std::uint32_t count = shapes_[i].count;
    const Vec2* const local = local_.data() + shapes_[i].first;
    Vec2* const placed = placed_.data() + shapes_[i].first;
    using namespace internal;
    const TwoDoubles turn{-rotation.sine, rotation.sine};
    const TwoDoubles shift = pair_of(position);
    for (std::uint32_t k = 0; k < count; ++k) {
      const TwoDoubles v = pair_of(local[k]);
      store_lanes(placed[k].data(), v * rotation.cosine + swapped(v) * turn + shift);
    }
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("thickness", self.thickness_);
    visit("densities", self.densities_);
    visit("bodies", self.bodies_);
    visit("shapes", self.shapes_);
    visit("ancestries", self.ancestries_);
    visit("materials", self.materials_);
    visit("dust", self.dust_);
    visit("local_vertices", self.local_);
    visit("unused_vertices", self.dead_vertices_);
    visit("next_id", self.next_id_);
  }
  /// Places all vertices.
  void restored() {
    placed_.resize(local_.size());
    for (BodyIndex i = 0; i < size(); ++i) update_ring(i);
  }

 private:
  void place(BodyIndex index, const ConvexPolygon& polygon, Motion motion, const Ancestry* parent);

  // Removes the vertices of particles that no longer exist.
  void compact();

  double thickness_;
  std::vector<double> densities_;  // of the materials
  std::vector<Body> bodies_;
  std::vector<ParticleShape> shapes_;
  std::vector<Ancestry> ancestries_;
  std::vector<MaterialIndex> materials_;
  std::vector<DustPiece> dust_;
  std::vector<Vec2> local_;
  std::vector<Vec2> placed_;
  std::size_t dead_vertices_ = 0;
  ParticleId next_id_ = 0;
};

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/particle/particles.ipp>
#endif
