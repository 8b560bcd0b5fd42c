// SPDX-License-Identifier: BSL-1.0
#include <riprap/simulation/setup.hpp>

#include <doctest/doctest.h>

#include <riprap/dynamics/boundary/periodic_cell.hpp>
#include <riprap/simulation/model.hpp>
#include <support/near.hpp>
#include <support/rectangle.hpp>

using namespace riprap;
using namespace riprap::test;

TEST_CASE("grains are added with their velocities, and platens are no grains") {
  const Assembly assembly{.particles = {{rectangle({0, 0}, 1, 1), Motion::free, {1, 2}, 3},
                                        {rectangle({2, 0}, 1, 3), Motion::strain_field},
                                        {rectangle({0, 4}, 9, 1), Motion::platen},
                                        {rectangle({0, -4}, 9, 1), Motion::prescribed}}};
  Particles particles(1, 2500);
  CHECK(add_particles(assembly, particles) == near_relative(2, 1e-14));
  REQUIRE(particles.size() == 4);
  CHECK(particles.body(0).velocity == Vec2{1, 2});
  CHECK(particles.body(0).angular_velocity == 3);
  Particles platens(1, 2500);
  CHECK(add_particles({.particles = {assembly.particles[2]}}, platens) == near_relative(9, 1e-14));
}

TEST_CASE("input that breaks a rule is refused") {
  const Assembly one{.particles = {{rectangle({0, 0}, 1, 1)}}};
  CHECK_NOTHROW((void)validated(Model{}, one, Rock{}));
  CHECK_THROWS_AS((void)validated(Model{}.check_every(0), one, Rock{}), InvalidInput);
  CHECK_THROWS_AS((void)validated(Model{}, one, Rock{.young = -1}), InvalidInput);
  CHECK_THROWS_WITH_AS((void)validated(Model{}, Assembly{}, Rock{}), "Assembly.particles is empty",
                       InvalidInput);
  Assembly periodic = one;
  periodic.period = {5, 5};
  CHECK_THROWS_WITH_AS((void)validated(Model{}, periodic, Rock{}),
                       "Assembly.period is set: give the model a PeriodicCell as its boundary",
                       InvalidInput);
  CHECK_NOTHROW((void)validated(Model{}.boundary(PeriodicCell{}), periodic, Rock{}));
}
