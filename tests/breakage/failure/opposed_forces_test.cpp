// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/failure/opposed_forces.hpp>

#include <doctest/doctest.h>

#include <support/loaded_disc.hpp>
#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

std::optional<OpposedForces> opposed(const std::vector<RadialForce>& forces) {
  return LoadedDisc::under(forces).particle(
      [](const LoadedParticle& particle) { return largest_opposed_forces(particle); });
}

}  // namespace

TEST_CASE("of two pairs of forces across a disc the larger one counts, by its smaller force") {
  const auto pair = opposed({{0, 900}, {0.5 * pi, 500}, {pi, 700}, {1.5 * pi, 1200}});
  REQUIRE(pair);
  CHECK(pair->force == near_relative(700, 1e-14));
  CHECK(pair->distance == near_relative(0.02, 1e-14));
  CHECK((pair->from - Vec2{0.01, 0}).norm() < 1e-16);
  CHECK((pair->to - Vec2{-0.01, 0}).norm() < 1e-16);
}

TEST_CASE("of forces at an angle the components along the line of their points count") {
  // At 120 degrees each makes 30 degrees with the lines to the others.
  const auto pair = opposed({{0, 900}, {2 * pi / 3, 900}, {4 * pi / 3, 900}});
  REQUIRE(pair);
  CHECK(pair->force == near_relative(900 * std::cos(pi / 6), 1e-13));
  CHECK(pair->distance == near_relative(0.02 * std::cos(pi / 6), 1e-13));
}

TEST_CASE("a single force, forces at one point and forces that pull have no opposed one") {
  CHECK_FALSE(opposed({}));
  CHECK_FALSE(opposed({{0, 900}}));
  CHECK_FALSE(opposed({{0, 900}, {0, 900}}));
  CHECK_FALSE(opposed({{0, -900}, {pi, -900}}));
}
