// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/breakage_input.hpp>

#include <doctest/doctest.h>

using namespace riprap;

TEST_CASE("input that breaks a rule becomes an error that names the particle") {
  Particles particles(1, 1);
  particles.add(ConvexPolygon{{0, 0}, {1, 0}, {0, 1}}, Motion::free);
  int done = 0;
  naming_particle(particles, 0, [&] { ++done; });
  CHECK(done == 1);
  CHECK_THROWS_WITH_AS(
      naming_particle(particles, 0, [] { throw InvalidInput("x = 1: must be 2"); }),
      "particle 0: x = 1: must be 2", SimulationError);
}
