// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The axioms of damping.

#include <cmath>
#include <utility>

#include <riprap/conformance/violations.hpp>
#include <riprap/core/random.hpp>
#include <riprap/dynamics/damping/concepts.hpp>

namespace riprap {

/// Which axioms a damping breaks, for bodies of about `mass` [kg] and polar moment of inertia
/// `inertia` [kg m^2].
template <Damping D>
[[nodiscard]] Violations damping_violations(const D& damping, double mass = 8e-3,
                                            double inertia = 3e-7) {
  AxiomCheck check;
  Random random(1);
  const auto number = [&random] { return random.uniform(-1, 1); };
  for (int i = 0; i < 200; ++i) {
    Body body;
    body.mass = mass * random.uniform(0.5, 2);
    body.inertia = inertia * random.uniform(0.5, 2);
    body.mass_scaling = random.uniform(1, 5);
    body.rotation = Rotation::from_angle(3 * number());
    const Wrench rest = damping(body, Wrench{});
    check.equal("no load and no motion, no damping", rest.force.norm() + std::abs(rest.moment), 0,
                0);

    body.velocity = {number(), number()};
    body.angular_velocity = 100 * number();
    const Wrench applied{{100 * number(), 100 * number()}, number()};
    for (const Wrench& load : {applied, Wrench{}}) {
      const Wrench damped = damping(body, load);
      check.at_most("damping never puts energy into a body: its power [W]",
                    damped.force.dot(body.velocity) + damped.moment * body.angular_velocity, 0);
    }
  }
  return std::move(check).violations();
}

}  // namespace riprap
