// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Where and how two bodies meet.

#include <riprap/core/vec2.hpp>

namespace riprap {

/// Geometry of one contact, in laboratory coordinates.
struct ContactGeometry {
  Vec2 normal{1, 0};  ///< unit vector from body a to body b
  Vec2 point{0, 0};   ///< where the force acts [m]
  double depth = 0;   ///< penetration [m], >= 0
  double area = 0;    ///< of the overlap [m^2]
  double chord = 0;   ///< length of the contact line [m]
  /// Rise of the depth per displacement of b against the normal at the point [-]: the force of an
  /// energy U(depth) is U'(depth) * depth_gradient, along the normal.
  double depth_gradient = 1;

  /// The normal turned by +90 degrees.
  [[nodiscard]] Vec2 tangent() const { return perpendicular(normal); }

  static void for_each_field(auto& self, auto&& visit) {
    visit("normal", self.normal);
    visit("point", self.point);
    visit("depth", self.depth);
    visit("area", self.area);
    visit("chord", self.chord);
    visit("depth_gradient", self.depth_gradient);
  }
};

}  // namespace riprap
