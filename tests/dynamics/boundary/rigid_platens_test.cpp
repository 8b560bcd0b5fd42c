// SPDX-License-Identifier: BSL-1.0
#include <riprap/dynamics/boundary/rigid_platens.hpp>

#include <doctest/doctest.h>

#include <algorithm>

#include <riprap/particle/random_box_assembly.hpp>
#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

ConvexPolygon box(const Vec2& low, const Vec2& high) {
  return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
}

// Inner faces at -3 and 4 along axis 1, at -1 and 2 along axis 2.
const Assembly uneven{.particles = {{box({-3.5, -9}, {-3, 9}), Motion::platen},
                                    {box({-9, 2}, {9, 4}), Motion::platen},
                                    {box({4, -9}, {5, 9}), Motion::platen},
                                    {box({-9, -2}, {9, -1}), Motion::platen},
                                    {box({0, 0}, {1, 1})},
                                    {box({3.8, 0}, {4.6, 1})},
                                    {box({-5, -5}, {-4.9, -4.9}), Motion::prescribed}}};

Particles placed(const Assembly& assembly) {
  Particles particles(1, 1);
  for (const PlacedParticle& p : assembly.particles) particles.add(p.polygon, p.motion);
  return particles;
}

}  // namespace

TEST_CASE("the sample is the rectangle between the inner faces") {
  const Particles particles = placed(uneven);
  RigidPlatens platens;
  platens.enclose(uneven, particles);
  const auto region = platens.region(particles);
  CHECK(region.area() == near(7 * 3, 1e-14));
  CHECK((region.semi_axes() - Vec2{3.5, 1.5}).norm() == near(0, 1e-15));
  CHECK(region.solid_area() == near(1.8, 1e-14));
  CHECK(region.lost() == 1);  // its centroid is in the platen
}

TEST_CASE("a step shortens the sample by rate times its extent, along each normal only") {
  Particles particles = placed(uneven);
  RigidPlatens platens;
  platens.enclose(uneven, particles);
  platens.set_rate(0.5, -0.25);
  CHECK(platens.rate() == Vec2{0.5, -0.25});
  const double dt = 1e-3;
  platens.drive(particles.bodies(), dt);
  for (Body& body : particles.bodies()) body.position += dt * body.velocity;
  CHECK((platens.region(particles).semi_axes() - Vec2{3.5 * (1 - 0.5 * dt), 1.5 * (1 + 0.25 * dt)})
            .norm() == near(0, 1e-14));
  for (BodyIndex i = 0; i < 4; ++i) CHECK(particles.body(i).velocity.prod() == 0);
  for (BodyIndex i = 4; i < 7; ++i) CHECK(particles.body(i).velocity == Vec2{0, 0});
}

TEST_CASE("platens do not turn, and move no further than they close the sample") {
  Particles particles = placed(uneven);
  RigidPlatens platens;
  platens.enclose(uneven, particles);
  particles.body(0).angular_velocity = 1;
  platens.drive(particles.bodies(), 1e-3);
  CHECK(particles.body(0).angular_velocity == 0);
  // The platens above and below reach from -9 to 9.
  particles.body(2).position.x() += 4.9;
  platens.drive(particles.bodies(), 1e-3);
  particles.body(2).position.x() += 0.2;
  CHECK_THROWS_AS(platens.drive(particles.bodies(), 1e-3), SimulationError);
}

TEST_CASE("bodies that platens would not move are an error that names the first") {
  Assembly mixed = uneven;
  mixed.particles[5].motion = Motion::strain_field;
  RigidPlatens platens;
  CHECK_THROWS_WITH_AS(platens.enclose(mixed, placed(mixed)),
                       "particle 5: RigidPlatens moves platens only", InvalidInput);
}

TEST_CASE("a side without a platen is an error") {
  Assembly three = uneven;
  three.particles[2].motion = Motion::free;
  RigidPlatens platens;
  CHECK_THROWS_WITH_AS(
      platens.enclose(three, placed(three)),
      "RigidPlatens needs four bodies of Motion::platen or Motion::wall, one on each side of the "
      "middle between them; the assembly has 3",
      InvalidInput);
  Assembly twice = uneven;
  twice.particles[2].polygon = box({-9, 5}, {9, 6});
  CHECK_THROWS_AS(platens.enclose(twice, placed(twice)), InvalidInput);
}

TEST_CASE("platens follow when a particle before them is removed, and stay themselves") {
  Assembly first = uneven;
  std::rotate(first.particles.begin(), first.particles.begin() + 4, first.particles.end());
  Particles particles = placed(first);  // platens are 3 to 6
  RigidPlatens platens;
  platens.enclose(first, particles);
  CHECK_THROWS_WITH_AS(platens.remove(4),
                       "RigidPlatens: body = 4: is a platen of the sample and must stay",
                       InvalidInput);
  platens.remove(1);
  particles.remove(1);
  CHECK(platens.region(particles).area() == near(7 * 3, 1e-14));
  platens.set_rate(1, 0);
  platens.drive(particles.bodies(), 1e-3);
  CHECK(particles.body(2).velocity.x() == near(3.5, 1e-14));
}
