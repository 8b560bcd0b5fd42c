// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A list of placed polygons: what a simulation starts from.

#include <string>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/core/ids.hpp>
#include <riprap/core/linkage.hpp>
#include <riprap/geometry/convex_polygon.hpp>
#include <riprap/particle/body.hpp>
#include <riprap/particle/placed_bond.hpp>

namespace riprap {

/// One particle before it has a mass.
struct PlacedParticle {
  ConvexPolygon polygon;  ///< in laboratory coordinates [m]
  Motion motion = Motion::free;
  Vec2 velocity{0, 0};          ///< [m/s]
  double angular_velocity = 0;  ///< [rad/s]
  MaterialIndex material = 0;   ///< in the simulation's list of rocks
};

/// Placed polygons of one out-of-plane thickness. Ids are given in the order of the list.
struct Assembly {
  double thickness = 0.016;  ///< [m]
  std::vector<PlacedParticle> particles;
  Vec2 period{0, 0};                ///< extents of a periodic cell [m]; zero: an open plane
  Vec2 centre{0, 0};                ///< of the periodic cell [m]
  double shear_offset = 0;          ///< of a sheared cell: see PeriodicDomain [m]
  std::vector<PlacedBond> bonds{};  ///< between particles; for models with a bond law

  /// The same particles, and cell, elsewhere.
  [[nodiscard]] Assembly moved(const Vec2& shift) const;

  /// Throws InvalidInput that names the particle, the value and the rule.
  void validate() const;
};

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/particle/assembly.ipp>
#endif
