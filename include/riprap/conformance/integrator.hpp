// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The axioms of the integrator.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <riprap/conformance/violations.hpp>
#include <riprap/core/random.hpp>
#include <riprap/dynamics/integrator/concepts.hpp>

namespace riprap {
namespace internal {

/// One whole step, as a simulation makes it. @param wrench  of the present pose, from a body
template <Integrator I, class Load>
void whole_step(const I& integrator, Body& body, double time_step, Load&& wrench) {
  integrator.advance(body, wrench(body), time_step);
  if (I::has_second_kick) integrator.second_kick(body, wrench(body), time_step);
}

[[nodiscard]] inline Body moving_body() {
  Body body;
  body.position = {1, -2};
  body.rotation = Rotation::from_angle(0.4);
  body.velocity = {3, 1};
  body.angular_velocity = -0.5;
  body.mass = 8;
  body.inertia = 2;
  return body;
}

/// Errors of an oscillator that starts at 1 m (or 0.1 rad) and at rest, two radians later, with
/// velocities over the circular frequency of 1 / s.
template <Integrator I>
[[nodiscard]] std::pair<double, double> oscillator_errors(const I& integrator, int steps) {
  Body body;
  body.position = {1, 0};
  body.rotation = Rotation::from_angle(0.1);
  body.mass = 8;
  body.inertia = 2;
  for (int i = 0; i < steps; ++i)
    whole_step(integrator, body, 2.0 / steps, [](const Body& b) -> Wrench {
      return {-b.mass * b.position, -b.inertia * b.rotation.angle()};
    });
  return {std::hypot(body.position.x() - std::cos(2), body.velocity.x() + std::sin(2)),
          std::hypot(body.rotation.angle() - 0.1 * std::cos(2),
                     body.angular_velocity + 0.1 * std::sin(2))};
}

template <Integrator I>
void check_order(const I& integrator, AxiomCheck& check) {
  const auto [way, turn] = oscillator_errors(integrator, 100);
  const auto [way_half, turn_half] = oscillator_errors(integrator, 200);
  // The next term of the expansion in the step, 0.02 of a radian, is some per cent of the first.
  check.equal("motion has the declared order", std::log2(way / way_half), I::order, 0.1);
  check.equal("turning has the declared order", std::log2(turn / turn_half), I::order, 0.1);
}

template <Integrator I>
void check_free_motion(const I& integrator, AxiomCheck& check) {
  const Body start = moving_body();
  Body body = start;
  for (int i = 0; i < 100; ++i)
    whole_step(integrator, body, 1e-3, [](const Body&) { return Wrench{}; });
  check.equal("a body without load keeps its velocity", (body.velocity - start.velocity).norm(), 0,
              1e-14);
  check.equal("a body without load keeps its spin", body.angular_velocity, start.angular_velocity,
              1e-14);
  check.equal("a body without load moves straight on",
              (body.position - start.position - 0.1 * start.velocity).norm(), 0, 1e-12);
  // Cayley's form of a turn is off by turn^3 / 12, 1e-11 of a radian a step.
  check.equal("a body without load turns evenly", body.rotation.angle(),
              start.rotation.angle() + 0.1 * start.angular_velocity, 1e-8);
  check.equal("a rotation stays one", std::hypot(body.rotation.cosine, body.rotation.sine), 1,
              1e-12);
}

/// Each kick does its work over its own share of the step: the energy ledger books it so.
template <Integrator I>
void check_work(const I& integrator, AxiomCheck& check) {
  const double time_step = 0.02;
  const double first = first_kick_fraction(integrator);
  Random random(1);
  const auto number = [&random] { return random.uniform(-1, 1); };
  const auto check_one = [&](Body& body, double share, auto&& part) {
    const Body before = body;
    const Wrench wrench{{100 * number(), 100 * number()}, 100 * number()};
    part(body, wrench);
    const double work = 0.5 * share * time_step *
                        (wrench.force.dot(before.velocity + body.velocity) +
                         wrench.moment * (before.angular_velocity + body.angular_velocity));
    check.equal("kinetic energy changes by the work over the mean velocity",
                body.kinetic_energy() - before.kinetic_energy(), work,
                1e-12 * (before.kinetic_energy() + body.kinetic_energy()));
  };
  for (int i = 0; i < 20; ++i) {
    Body body = moving_body();
    body.velocity = {number(), number()};
    body.angular_velocity = number();
    body.mass_scaling = random.uniform(1, 5);
    check_one(body, first, [&](Body& b, const Wrench& w) { integrator.advance(b, w, time_step); });
    if (I::has_second_kick)
      check_one(body, 1 - first,
                [&](Body& b, const Wrench& w) { integrator.second_kick(b, w, time_step); });
  }
}

template <Integrator I>
void check_mass_scaling(const I& integrator, AxiomCheck& check) {
  Body heavy = moving_body();
  Body scaled = moving_body();
  scaled.mass_scaling = 4;
  heavy.mass *= 4;
  heavy.inertia *= 4;
  for (Body* body : {&heavy, &scaled})
    whole_step(integrator, *body, 0.02, [](const Body&) { return Wrench{{70, -30}, 20}; });
  check.equal("scaled mass is mass in motion", (heavy.velocity - scaled.velocity).norm(), 0, 1e-12);
  check.equal("scaled inertia is inertia in turning", scaled.angular_velocity,
              heavy.angular_velocity, 1e-12);
  check.equal("the true mass stays", scaled.mass, moving_body().mass, 0);
  check.equal("the true inertia stays", scaled.inertia, moving_body().inertia, 0);
}

}  // namespace internal

/// Which axioms an integrator breaks.
template <Integrator I>
[[nodiscard]] Violations integrator_violations(const I& integrator) {
  AxiomCheck check;
  internal::check_order(integrator, check);
  internal::check_free_motion(integrator, check);
  internal::check_work(integrator, check);
  internal::check_mass_scaling(integrator, check);
  return std::move(check).violations();
}

}  // namespace riprap
