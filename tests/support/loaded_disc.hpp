// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A disc, to within its corners, under radial contact forces.

#include <utility>
#include <vector>

#include <riprap/conformance/loaded_sample.hpp>
#include <riprap/geometry/polygon_properties.hpp>
#include <support/polygons.hpp>

namespace riprap::test {

/// Force [N] towards the centre, at an angle [rad].
struct RadialForce {
  double angle = 0;
  double force = 0;
};

/// A regular polygon of 64 corners on a circle of 20 mm, 10 mm thick. At angles of corners the
/// forces are on the circle.
struct LoadedDisc {
  static constexpr double diameter = 0.02;
  static constexpr double thickness = 0.01;
  static constexpr std::size_t sides = 64;

  [[nodiscard]] static ConvexPolygon polygon() { return regular_polygon(sides, 0.5 * diameter); }
  /// Of the polygon over that of the circle.
  [[nodiscard]] static double area_share() {
    return polygon_area(polygon().ring()) / (0.25 * pi * diameter * diameter);
  }
  [[nodiscard]] static internal::LoadedSample under(const std::vector<RadialForce>& forces) {
    internal::LoadedSample sample{polygon(), thickness, {}};
    for (const RadialForce& f : forces) {
      const Vec2 outwards = Rotation::from_angle(f.angle) * Vec2{1, 0};
      ContactLoad load;
      load.arm_lab = 0.5 * diameter * outwards;
      load.force_lab = -f.force * outwards;
      load.normal_force = f.force;
      sample.loads.push_back(load);
    }
    return sample;
  }
  /// 2 F / (pi D t) [Pa].
  [[nodiscard]] static double tension(double force) {
    return 2 * force / (pi * diameter * thickness);
  }
};

/// What a trigger or a line fit says of a sample.
template <class P>
[[nodiscard]] auto ask(const P& policy, const internal::LoadedSample& sample) {
  return sample.particle([&](const LoadedParticle& particle) { return policy(particle); });
}

}  // namespace riprap::test
