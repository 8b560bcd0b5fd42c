// SPDX-License-Identifier: BSL-1.0
#include <riprap/particle/smallest_mass.hpp>

#include <doctest/doctest.h>

#include <support/rectangle.hpp>

using namespace riprap;
using test::rectangle;

TEST_CASE("the smallest intact free particle decides, and pieces do not") {
  Particles particles(1, 1000);
  CHECK(smallest_intact_mass(particles, 7) == 7);
  particles.add(rectangle({0, 0}, 1, 0.5), Motion::prescribed);  // 500 kg
  CHECK(smallest_intact_mass(particles, 7) == 500);
  particles.add(rectangle({3, 0}, 2, 1), Motion::free);  // 2000 kg
  particles.add(rectangle({6, 0}, 1, 1), Motion::free);  // 1000 kg
  CHECK(smallest_intact_mass(particles, 7) == 1000);
  const Ancestry broken = particles.ancestry(2);
  particles.replace(2, rectangle({6, 0}, 0.25, 1), Motion::free, broken);
  CHECK(smallest_intact_mass(particles, 7) == 2000);
}
