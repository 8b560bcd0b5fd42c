// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Puts the pieces of a particle that breaks in its place.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <riprap/breakage/crack.hpp>
#include <riprap/geometry/convex_polygon.hpp>
#include <riprap/particle/particles.hpp>
#include <riprap/simulation/break_event.hpp>

namespace riprap {

/// The record of a particle that breaks, without its pieces.
[[nodiscard]] inline BreakEvent event_of(const Crack& crack, const Ancestry& particle,
                                         std::uint64_t step, double time) {
  return {.step = step,
          .time = time,
          .particle = particle,
          .failures = crack.failures,
          .mode = crack.mode,
          .line = crack.line,
          .crack_length = crack.length};
}

/// The left piece takes the place of particle i, the right one is new; where one of them is dust,
/// the other takes the place. Fills ids, areas and centroids of the event in.
/// @param smallest_mass of the intact particles [kg], by which masses are scaled
/// @return the index of the new piece; i, if there is none
template <class ModelType>
BodyIndex replace_by_pieces(const ModelType& model, double smallest_mass, const Crack& crack,
                            BodyIndex i, Particles& particles, BreakEvent& event) {
  const Body parent = particles.body(i);
  const Ancestry ancestry = particles.ancestry(i);
  BodyIndex index = i;
  bool has_place = true;  // not taken yet
  for (std::size_t k = 0; k < 2; ++k) {
    const std::vector<Vec2>& ring = k == 0 ? crack.pieces.left : crack.pieces.right;
    const AreaProperties properties = area_properties(ring);
    event.areas[k] = properties.area;
    event.centroids[k] = properties.centroid;
    if (crack.is_dust[k]) {
      particles.add_dust(ancestry, properties.area, particles.material(i));
      continue;
    }
    const ConvexPolygon piece{ring};
    if (has_place)
      particles.replace(i, piece, Motion::free, ancestry);
    else
      index = particles.add(piece, Motion::free, &ancestry, particles.material(i));
    has_place = false;
    Body& body = particles.body(index);
    model.breakage_model.inheritance(parent, body);
    body.mass_scaling = model.motion_model.time_step.mass_scaling(body.mass, smallest_mass);
    event.pieces[k] = particles.ancestry(index).id;
  }
  return index;
}

/// The indices of the pieces on the left and on the right; none of one that is dust.
/// @param second what `replace_by_pieces` returned
[[nodiscard]] inline std::array<std::optional<BodyIndex>, 2>
pieces_of(const Crack& crack, BodyIndex i, BodyIndex second) {
  std::array<std::optional<BodyIndex>, 2> pieces;
  if (!crack.is_dust[0]) pieces[0] = i;
  if (!crack.is_dust[1]) pieces[1] = crack.is_dust[0] ? i : second;
  return pieces;
}

}  // namespace riprap
