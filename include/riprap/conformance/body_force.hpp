// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The axioms of the body force.

#include <utility>

#include <riprap/conformance/violations.hpp>
#include <riprap/core/random.hpp>
#include <riprap/dynamics/body_force/concepts.hpp>

namespace riprap {

/// Which axioms a body force breaks, for bodies within `extent` [m] of the origin at up to
/// `speed` [m/s].
template <BodyForce F>
[[nodiscard]] Violations body_force_violations(const F& body_force, double extent = 1,
                                               double speed = 10) {
  AxiomCheck check;
  Random random(1);
  const auto vector = [&random](double size) {
    return Vec2{random.uniform(-size, size), random.uniform(-size, size)};
  };
  for (int i = 0; i < 200; ++i) {
    Body body;
    body.mass = 8e-3;
    body.position = vector(extent);
    body.velocity = vector(speed);
    const Vec2 first = body_force(body);
    check.holds("the acceleration is finite", is_finite(first));
    check.equal("the same body has the same acceleration: difference [m/s^2]",
                (body_force(body) - first).norm(), 0, 0);
    // Of twice the mass under twice the force.
    body.mass *= 2;
    check.equal("a body force is proportional to the mass: difference [m/s^2]",
                (body_force(body) - first).norm(), 0, 1e-12 * first.norm());
  }
  return std::move(check).violations();
}

}  // namespace riprap
