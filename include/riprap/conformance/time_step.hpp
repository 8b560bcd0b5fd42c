// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The axioms of the time-step rule.

#include <cmath>
#include <limits>
#include <utility>

#include <riprap/conformance/violations.hpp>
#include <riprap/dynamics/time_step/concepts.hpp>

namespace riprap {

/// Which axioms a time-step rule breaks where the smallest intact particle has `mass` [kg] and the
/// contact law's peak stiffness is `stiffness` [N/m].
template <TimeStep Rule>
[[nodiscard]] Violations time_step_violations(const Rule& rule, double mass = 4e-3,
                                              double stiffness = 2e7) {
  AxiomCheck check;
  const double time_step = rule.time_step(mass, stiffness);
  check.at_least("the time step is above zero", time_step, std::numeric_limits<double>::min());
  // Beyond 2 sqrt(m / k) leapfrog is unstable (Courant, Friedrichs and Lewy 1928).
  check.at_most("the smallest intact particle on a contact's spring is stable", time_step,
                2 * std::sqrt(rule.mass_scaling(mass, mass) * mass / stiffness));
  for (const double share : {1e-3, 0.1, 0.5, 1.0, 2.0, 1e3}) {
    check.at("mass over the smallest", share);
    check.at_least("no body is made lighter", rule.mass_scaling(share * mass, mass), 1);
  }
  return std::move(check).violations();
}

}  // namespace riprap
