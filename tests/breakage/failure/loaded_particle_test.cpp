// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/failure/loaded_particle.hpp>

#include <doctest/doctest.h>

#include <vector>

#include <riprap/breakage/criterion/rankine.hpp>
#include <riprap/geometry/polygon_properties.hpp>
#include <support/near.hpp>
#include <support/polygons.hpp>

using namespace riprap;
using namespace riprap::test;

TEST_CASE("a loaded particle shows shape, loads and mean stress in laboratory axes") {
  Particles particles(0.01, 2500);
  particles.add(rectangle(1, 1), Motion::free);
  const ConvexPolygon slab = rectangle(0.02, 0.01).moved(Rotation::from_angle(0.3), {4, -2});
  particles.add(slab, Motion::free);
  const Rotation turn = Rotation::from_angle(0.3);
  const std::vector<ContactLoad> loads{
      {.arm_lab = turn * Vec2{0, 0.005}, .force_lab = turn * Vec2{0, -3000}, .normal_force = 3000},
      {.arm_lab = turn * Vec2{0, -0.005}, .force_lab = turn * Vec2{0, 3000}, .normal_force = 3000}};
  const Rock rock{.young = 5e9};
  const Rankine rankine{};
  const CriterionView criterion{rankine};
  const LoadedParticle particle{particles, 1, loads, rock, criterion};

  CHECK(particle.id() == 1);
  CHECK(&particle.body() == &particles.body(1));
  CHECK(particle.ring().data() == particles.ring(1).data());
  CHECK(particle.centroid() == particles.body(1).position);
  CHECK(particle.area() == near_relative(2e-4, 1e-12));
  CHECK(particle.thickness() == 0.01);
  CHECK(particle.rock().young == 5e9);
  CHECK(particle.criterion().tensile_strength() == rankine.tensile_strength());
  REQUIRE(particle.loads().size() == 2);
  const Vec2 top = particle.point(particle.loads()[0]);
  CHECK((top - Vec2{4, -2} - loads[0].arm_lab).norm() < 1e-14);

  const PrincipalStress principal = particle.mean_stress().principal();
  CHECK(principal.major == near_relative(3000 * 0.01 / (2e-4 * 0.01), 1e-12));
  CHECK(principal.minor == near(0, 1e-12 * principal.major));
  CHECK(std::abs(cross(principal.major_direction, turn * Vec2{0, 1})) < 1e-12);
}
