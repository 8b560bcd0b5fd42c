// SPDX-License-Identifier: BSL-1.0
// The shear box of examples/direct_shear.

#include <direct_shear/features.hpp>
#include <direct_shear/shear_box.hpp>
#include <doctest/doctest.h>

#include <riprap/experiment/wall_servo.hpp>
#include <support/near.hpp>
#include <support/rectangle.hpp>
#include <support/unbreakable.hpp>

using namespace riprap;
using namespace riprap::test;
using namespace direct_shear;

TEST_CASE("two blocks in a shear box slide on each other with the friction of their contact") {
  // Flat blocks, each 1 mm from the side that will push it, too short for the other half's sides
  // to come between them.
  const double friction = 0.3;
  const double normal = 1e5;
  const EnergyConservingSpring law{
      .normal_stiffness = 1e8, .tangential_stiffness = 1e8, .friction = friction};
  Assembly assembly =
      of(box_walls({.width = 2, .height = 1, .parting = 0.5, .thickness = 0.3}, Motion::platen));
  assembly.particles.push_back({rectangle({-0.199, 0.25}, 1.6, 0.5)});
  assembly.particles.push_back({rectangle({0.199, 0.75}, 1.6, 0.5)});
  Simulation sim{Model{}.criterion(NeverFails{}).boundary(NoBoundary{}).contact_law(law), assembly,
                 rock_of(2000)};
  // Three contacts in series, each of twice the stiffness of a corner.
  WallServo servo(lid, {0, -1}, normal, 2e8 / 3, 100 * sim.time_step(), 0.05);
  const auto mean_of_steps = [&](int count) {
    BoxForces sum;
    for (int n = 0; n < count; ++n) {
      servo(sim);
      sim.step();
      sum += forces(sim);
    }
    return 1.0 / count * sum;
  };
  (void)mean_of_steps(8000);
  const BoxForces pressed = mean_of_steps(1);
  CHECK(pressed.normal_lid == near_relative(normal, 1e-4));
  CHECK(pressed.normal_plane == near_relative(normal, 1e-4));
  CHECK(pressed.shear_lower == near(pressed.shear_upper, 1e-4 * normal));
  move_lower_half(sim, 0.02);
  (void)mean_of_steps(8000);
  const BoxForces sliding = mean_of_steps(2000);
  CHECK(sim.particles().body(lower_plate).position.x() > 0.01);
  // The servo and the blocks swing a little about the balance.
  CHECK(sliding.normal_plane == near_relative(normal, 2e-3));
  CHECK(sliding.shear_lower == near_relative(friction * normal, 5e-3));
  CHECK(sliding.shear_upper == near_relative(friction * normal, 5e-3));
}

TEST_CASE("a box must have its parting plane between its plates") {
  CHECK_THROWS_WITH_AS(
      (void)box_walls({.width = 1, .height = 2, .parting = 2, .thickness = 1}, Motion::wall),
      "BoxSize.parting = 2: must lie in (0, BoxSize.height)", InvalidInput);
  CHECK_THROWS_AS(
      (void)box_walls({.width = 0, .height = 2, .parting = 1, .thickness = 1}, Motion::wall),
      InvalidInput);
}

TEST_CASE("peak, end, dilation and balance are those of the records that they are made from") {
  // 100 records over 0.1 m: shear rises to 0.8 of the normal force at 40 and falls to 0.6 at 60.
  // The lid rises by 0.2 of the way; the upper half carries 1 % less.
  BoxResult r{.size = {.width = 0.5}, .thickness = 0.02};
  for (int n = 1; n <= 100; ++n) {
    const double ratio = n <= 40 ? 0.02 * n : n <= 60 ? 0.8 - 0.01 * (n - 40) : 0.6;
    r.records.push_back({.displacement = 0.001 * n,
                         .lift = 0.0002 * n,
                         .forces = {ratio * 1e4, 0.99 * ratio * 1e4, 0.8e4, 1e4}});
  }
  const Features f = features(r);
  // The best mean of five records around the peak: 0.78, 0.8, 0.79, 0.78, 0.77.
  CHECK(f.peak.ratio() == near_relative(0.784, 1e-12));
  CHECK(f.peak.normal == near_relative(1e4 / 0.01, 1e-12));
  CHECK(f.peak.displacement == near_relative(0.041, 1e-12));
  CHECK(f.end.ratio() == near_relative(0.6, 1e-12));
  CHECK(f.dilation == near_relative(0.2, 1e-12));
  CHECK(f.imbalance == near_relative(0.01 / 0.995, 1e-12));
  CHECK(f.mean_offset == near_relative(0.01 / 0.995, 1e-12));
  CHECK(f.plane_over_lid == near_relative(1.25, 1e-12));
  r.records.resize(4);
  CHECK_THROWS_AS((void)features(r), InvalidInput);
}
