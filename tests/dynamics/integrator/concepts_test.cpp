// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <doctest/doctest.h>

#include <riprap/dynamics/integrator/concepts.hpp>
#include <support/archetypes.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near_relative;
namespace archetype = riprap::test::archetype;

namespace {

struct WithoutOrder : archetype::Integrator {
  void order() const {}
};
struct OrderOfAnObject : archetype::Integrator {
  int order = 1;
};
struct WithoutNeedsFinish : archetype::Integrator {
  void has_second_kick() const {}
};
struct NeedsFinishIsNoConstant : archetype::Integrator {
  static inline bool has_second_kick = true;
};
struct WithoutAdvance : archetype::Integrator {
  void advance() const {}
};
struct WithoutFinish : archetype::Integrator {
  void second_kick() const {}
};
struct Remembers : archetype::Integrator {
  void advance(Body&, const Wrench&, double) {}
};
struct ChangesTheWrench : archetype::Integrator {
  void advance(Body&, Wrench&, double) const {}
};
struct NeedsFinishOfAnObject : archetype::Integrator {
  bool has_second_kick = true;
};
struct ChangesTheStep : archetype::Integrator {
  void advance(Body&, const Wrench&, double&) const {}
};
struct FinishIsNotConst : archetype::Integrator {
  void second_kick(Body&, const Wrench&, double) {}
};
struct FinishChangesTheWrench : archetype::Integrator {
  void second_kick(Body&, Wrench&, double) const {}
};
struct FinishChangesTheStep : archetype::Integrator {
  void second_kick(Body&, const Wrench&, double&) const {}
};

static_assert(Integrator<archetype::Integrator>);
static_assert(!Integrator<WithoutOrder>);
static_assert(!Integrator<OrderOfAnObject>);
static_assert(!Integrator<WithoutNeedsFinish>);
static_assert(!Integrator<NeedsFinishIsNoConstant>);
static_assert(!Integrator<WithoutAdvance>);
static_assert(!Integrator<WithoutFinish>);
static_assert(!Integrator<Remembers>);
static_assert(!Integrator<ChangesTheWrench>);

struct FirstKickNotConst : archetype::Integrator {
  double first_kick_fraction() { return 0.5; }
};
static_assert(!Integrator<FirstKickNotConst>);
static_assert(!Integrator<NeedsFinishOfAnObject>);
static_assert(!Integrator<ChangesTheStep>);
static_assert(!Integrator<FinishIsNotConst>);
static_assert(!Integrator<FinishChangesTheWrench>);
static_assert(!Integrator<FinishChangesTheStep>);

struct OneKick : archetype::Integrator {
  using archetype::Integrator::Integrator;
  static constexpr bool has_second_kick = false;
};

struct ThirdFirst : archetype::Integrator {
  using archetype::Integrator::Integrator;
  double first_kick_fraction() const { return 1.0 / 3; }
};

Body moving_body() {
  Body body;
  body.position = {1, 2};
  body.rotation = Rotation::from_angle(0.3);
  body.velocity = {3, -4};
  body.angular_velocity = 0.5;
  body.mass = 8;
  body.inertia = 2;
  return body;
}

}  // namespace

TEST_CASE("a drift moves and turns a body at its velocity and changes nothing else") {
  Body body = moving_body();
  drift(body, 0.01);
  CHECK((body.position - Vec2{1.03, 1.96}).norm() <= 1e-15);
  // Cayley's turn differs from the angle by turn^3 / 12 = 1e-8.
  CHECK(std::abs(body.rotation.angle() - 0.305) <= std::pow(0.005, 3) / 12 + 1e-15);
  CHECK(body.velocity == Vec2{3, -4});
  CHECK(body.angular_velocity == 0.5);
}

TEST_CASE("a body that does not turn keeps its rotation to the last bit") {
  Body body = moving_body();
  body.angular_velocity = 0;
  for (int i = 0; i < 1000; ++i) drift(body, 0.01);
  CHECK(body.rotation.cosine == std::cos(0.3));
  CHECK(body.rotation.sine == std::sin(0.3));
}

TEST_CASE("a kick adds impulse over mass and angular impulse over inertia") {
  Body body = moving_body();
  kick(body, {{16, 8}, -6}, 0.5);
  CHECK(body.velocity == Vec2{4, -3.5});
  CHECK(body.angular_velocity == -1);
  CHECK(body.position == Vec2{1, 2});
}

TEST_CASE("a kick changes the velocity in inverse proportion to the scaled mass") {
  Body body = moving_body();
  body.mass_scaling = 4;
  kick(body, {{16, 8}, -6}, 0.5);
  CHECK(body.velocity == Vec2{3.25, -3.875});
  CHECK(body.angular_velocity == 0.125);
}

TEST_CASE("a kick changes kinetic energy by the work over the mean of both velocities") {
  for (const double scaling : {1.0, 3.7}) {
    Body body = moving_body();
    body.mass_scaling = scaling;
    const Body before = body;
    const Wrench wrench{{1234, -56}, 78};
    kick(body, wrench, 0.02);
    const double work =
        0.02 * (wrench.force.dot(0.5 * (before.velocity + body.velocity)) +
                wrench.moment * 0.5 * (before.angular_velocity + body.angular_velocity));
    CHECK(body.kinetic_energy() - before.kinetic_energy() == near_relative(work, 1e-12));
  }
}

TEST_CASE("the first kick is all or half of the impulse, unless the integrator says otherwise") {
  CHECK(first_kick_fraction(OneKick{0}) == 1);
  CHECK(first_kick_fraction(archetype::Integrator{0}) == 0.5);
  CHECK(first_kick_fraction(ThirdFirst{0}) == 1.0 / 3);
}
