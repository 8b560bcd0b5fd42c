// SPDX-License-Identifier: BSL-1.0
#include <riprap/dynamics/body_force/no_body_force.hpp>

#include <doctest/doctest.h>

#include <vector>

#include <riprap/simulation/body_step.hpp>
#include <riprap/simulation/model_parts.hpp>

using namespace riprap;

TEST_CASE("without a body force a body at rest stays at rest") {
  CHECK(NoBodyForce{}(Body{}) == Vec2{0, 0});
  Particles particles(1, 2500);
  particles.add(ConvexPolygon{{0, 0}, {1, 0}, {0, 1}}, Motion::free);
  const auto start = particles.body(0).position;
  const MotionModel motion{SymplecticEuler{}, LocalDamping{}, MassFloor{}, StrainField{},
                           NoBodyForce{}};
  std::vector<BodyWork> work(1);
  BodyStep(motion, UnboundedDomain{}, 0.1).advance(particles, 0, 1, work);
  CHECK(particles.body(0).position == start);
  CHECK(work[0].body_force == 0);
}
