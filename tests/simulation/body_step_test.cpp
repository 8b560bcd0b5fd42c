// SPDX-License-Identifier: BSL-1.0
#include <riprap/simulation/body_step.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

#include <riprap/dynamics/body_force/uniform_body_force.hpp>
#include <riprap/dynamics/damping/viscous_damping.hpp>
#include <riprap/dynamics/integrator/symplectic_euler.hpp>
#include <riprap/dynamics/integrator/velocity_verlet.hpp>
#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

template <class Scheme>
struct Motion2 {
  Scheme integrator{};
  ViscousDamping damping{.rate = 10};
  UniformBodyForce body_force{};
};

constexpr double dt = 1e-3;

std::vector<BodyWork> unused(2);

// A free body of 2 kg and a driven one, both at 3 m/s and pushed by 4 N along axis 1.
Particles pushed() {
  Particles particles(1, 2);
  const ConvexPolygon square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  particles.add(square, Motion::free);
  particles.add(square.moved({}, {5, 0}), Motion::prescribed);
  for (Body& body : particles.bodies()) {
    body.velocity = {3, 0};
    body.contact.force = {4, 0};
  }
  return particles;
}

}  // namespace

TEST_CASE_TEMPLATE("kinetic energy is what contacts, body force and damping leave", Scheme,
                   SymplecticEuler, VelocityVerlet) {
  Particles particles = pushed();
  const Body before = particles.body(0);
  const Motion2<Scheme> motion{.body_force = {{0, -9.81}}};
  const BodyStep step(motion, UnboundedDomain{}, dt);
  CHECK(step.first_kick_time() + step.second_kick_time() == near(dt, 1e-18));
  std::vector<BodyWork> works(2);
  step.advance(particles, 0, 2, works);
  if (step.has_second_kick) step.second_kick(particles, 0, 2, works);
  CHECK(works[1].damping == 0);
  const BodyWork work = total_work(works);

  const Body& after = particles.body(0);
  // Contacts do 4 N times the displacement at the mean velocity of each kick. Damping makes two
  // kicks differ by 10/s * 1 ms, one per cent, and the means of the means by the square of that
  // over 16.
  const double by_contacts = 4 * dt * 0.5 * (before.velocity.x() + after.velocity.x());
  CHECK(after.kinetic_energy() - before.kinetic_energy() ==
        near(by_contacts + work.body_force - work.damping, 1e-5 * by_contacts));
  CHECK(work.damping == near_relative(10 * 2 * 3 * 3 * dt, 0.01));
  CHECK(work.body_force > 0);
  // The driven body resists 4 N.
  CHECK(work.boundary == near(-4 * 3 * dt, 1e-16));
}

TEST_CASE("a driven body drifts at its velocity whatever pushes it, and vertices follow") {
  Particles particles = pushed();
  const Motion2<SymplecticEuler> motion{};
  BodyStep(motion, UnboundedDomain{}, dt).advance(particles, 0, 2, unused);
  CHECK(particles.body(1).velocity == Vec2{3, 0});
  CHECK(particles.ring(1)[0].x() == near(5 + 3 * dt, 1e-15));
  CHECK(particles.ring(0)[0].x() > 3 * dt * 0.98);
}

TEST_CASE("a state that is no longer finite is an error that names the particle, free or driven") {
  const Motion2<SymplecticEuler> motion{};
  const BodyStep step(motion, UnboundedDomain{}, dt);
  Particles particles = pushed();
  particles.body(0).contact.force.x() = std::numeric_limits<double>::infinity();
  CHECK_THROWS_WITH_AS(step.advance(particles, 0, 2, unused),
                       "particle 0: position (inf, 0.5) m, spin 0 rad/s: no longer finite",
                       SimulationError);
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    Particles driven = pushed();
    driven.body(1).velocity.y() = bad;
    CHECK_THROWS_AS(step.advance(driven, 0, 2, unused), SimulationError);
    Particles turned = pushed();
    turned.body(1).angular_velocity = bad;
    CHECK_THROWS_AS(step.advance(turned, 0, 2, unused), SimulationError);
  }
}

TEST_CASE("a body that a step would take past others is an error with its speed and the step") {
  const Motion2<SymplecticEuler> motion{};
  const BodyStep step(motion, UnboundedDomain{}, dt);
  // Half the circumradius of the unit squares, 0.354 m, in a millisecond.
  for (const BodyIndex i : {0u, 1u}) {
    Particles slow = pushed();
    slow.body(i).velocity = {0, 350};
    CHECK_NOTHROW(step.advance(slow, 0, 2, unused));
    Particles fast = pushed();
    fast.body(i).velocity = {0, 360};
    CHECK_THROWS_WITH_AS(step.advance(fast, 0, 2, unused),
                         doctest::Contains("contacts would be missed"), SimulationError);
    Particles turning = pushed();
    turning.body(i).angular_velocity = 510;
    CHECK_THROWS_WITH_AS(
        step.advance(turning, 0, 2, unused),
        doctest::Contains(i == 0 ? "particle 0: moves at 2."
                                 : "particle 1: moves at 3 m/s and 510 rad/s, in a time step of "
                                   "0.001 s by more than half its circumradius of 0.707106781"),
        SimulationError);
  }
}
