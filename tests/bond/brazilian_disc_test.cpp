// SPDX-License-Identifier: BSL-1.0
// A disc of bonded cells between two plates, and an elastic disc under two opposed forces.

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include <riprap/bond/bond_law/brittle_bond.hpp>
#include <riprap/dynamics/boundary/no_boundary.hpp>
#include <riprap/dynamics/damping/local_damping.hpp>
#include <riprap/measurement/contact_stress.hpp>
#include <riprap/particle/bonded_cells.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

constexpr double radius = 0.05;     // [m]
constexpr double thickness = 0.02;  // [m]

Assembly disc_and_plates(double speed) {
  constexpr unsigned sides = 64;
  std::vector<Vec2> corners;
  for (unsigned k = 0; k < sides; ++k)
    corners.push_back(Rotation::from_angle(2 * std::numbers::pi * k / sides) * Vec2{0, radius});
  Assembly all = bonded_cells(
      {.thickness = thickness, .particles = {{.polygon = ConvexPolygon(std::move(corners))}}},
      {.count = 400, .seed = 2});
  for (const double side : {1, -1}) {
    const double low = side > 0 ? radius : -2 * radius;
    all.particles.push_back(
        {ConvexPolygon{
             {-radius, low}, {radius, low}, {radius, low + radius}, {-radius, low + radius}},
         Motion::wall,
         {0, -side * speed}});
  }
  return all;
}

// Of a disc under two opposed forces [N/m] on axis 2, whatever its elastic constants: two radial
// fields from the points where the forces act, and a uniform tension (Timoshenko and Goodier,
// Theory of Elasticity, 1970, section 41). At the centre -F / (pi R t) and 3 F / (pi R t).
Stress2 elastic_stress(const Vec2& at, double force) {
  const double tension = force / (std::numbers::pi * radius);
  Stress2 sum{-tension, -tension, 0};
  for (const double side : {1, -1}) {
    const Vec2 from = at - Vec2{0, side * radius};
    const double distance = from.norm();
    const Vec2 n = from / distance;
    const double radial = 2 * force / std::numbers::pi * std::abs(n.y()) / distance;
    sum += radial * Stress2{n.x() * n.x(), n.y() * n.y(), n.x() * n.y()};
  }
  return sum;
}

}  // namespace

TEST_CASE("in the middle of a bonded disc stresses are those of an elastic one") {
  constexpr BrittleBond unbreakable{.normal_stiffness = 1e12,
                                    .tangential_stiffness = 1e12,
                                    .tensile_strength = 1e12,
                                    .cohesion = 1e12};
  Simulation sim{Model{}
                     .criterion(NeverFails{})
                     .boundary(NoBoundary{})
                     .damping(LocalDamping{0.7})
                     .bond_law(unbreakable),
                 disc_and_plates(0.05), Rock{}};
  const auto upper = static_cast<BodyIndex>(sim.particles().size() - 2);
  const auto lower = static_cast<BodyIndex>(upper + 1);
  while (sim.force_on(upper).force.y() < 2000) sim.step();
  for (const BodyIndex plate : {upper, lower}) sim.set_velocity(plate, {0, 0}, 0);
  for (int k = 0; k < 20000; ++k) sim.step();
  const double force = sim.force_on(upper).force.y();
  REQUIRE(force > 1000);
  CHECK(-sim.force_on(lower).force.y() == near(force, 1e-3 * force));

  const std::vector<Stress2> stresses = contact_stresses(sim.interactions(), sim.particles());
  Stress2 error;
  double area = 0;
  for (BodyIndex i = 0; i < upper; ++i) {
    const Vec2& at = sim.particles().body(i).position;
    if (at.norm() > 0.5 * radius) continue;
    const double share = sim.particles().shape(i).area;
    error += share * stresses[i];
    error += -share * elastic_stress(at, force / thickness);
    area += share;
  }
  // The stress of a single cell scatters; the mean of some hundred is within a hundredth.
  const double unit = force / (std::numbers::pi * radius * thickness);
  CHECK(std::abs(error.s11) < 0.03 * area * unit);
  CHECK(std::abs(error.s22) < 0.03 * area * unit);
  CHECK(std::abs(error.s12) < 0.03 * area * unit);
}
