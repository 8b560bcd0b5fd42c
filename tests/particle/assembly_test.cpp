// SPDX-License-Identifier: BSL-1.0
#include <riprap/particle/assembly.hpp>

#include <doctest/doctest.h>
#include <limits>

#include <support/message_of.hpp>
#include <support/polygons.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

Assembly three_squares() {
  Assembly assembly;
  for (int i = 0; i < 3; ++i) assembly.particles.push_back({shifted(unit_square(), {2.0 * i, 0})});
  return assembly;
}

std::string complaint(const Assembly& assembly) {
  return message_of([&] { assembly.validate(); });
}

}  // namespace

TEST_CASE("a placed particle is free and at rest unless something else is said") {
  const PlacedParticle particle{unit_square()};
  CHECK(particle.motion == Motion::free);
  CHECK(particle.velocity.norm() == 0);
  CHECK(particle.angular_velocity == 0);
}

TEST_CASE("an assembly at rest is valid, also an empty one") {
  CHECK(complaint({}).empty());
  CHECK(complaint(three_squares()).empty());
}

TEST_CASE("thickness is above zero") {
  Assembly assembly = three_squares();
  for (const double thickness : {0.0, -0.016, infinity, not_a_number}) {
    assembly.thickness = thickness;
    CHECK(complaint(assembly) ==
          "Assembly.thickness = " + to_text(thickness) + ": must be a finite number above 0");
  }
}

TEST_CASE("a velocity that is not finite names its particle") {
  for (const double bad : {infinity, not_a_number}) {
    Assembly assembly = three_squares();
    assembly.particles[2].velocity = {0, bad};
    CHECK(contains(complaint(assembly), "particle 2: velocity must be finite"));
    assembly = three_squares();
    assembly.particles[1].angular_velocity = bad;
    CHECK(contains(complaint(assembly), "particle 1"));
    CHECK(contains(complaint(assembly), "must be finite"));
  }
}
