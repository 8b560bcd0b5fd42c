// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Simulations of rigid bodies that do not break.

#include <utility>
#include <vector>

#include <riprap/contact/contact_law/linear_spring_coulomb.hpp>
#include <riprap/contact/narrow_phase/overlap_chord.hpp>
#include <riprap/dynamics/boundary/no_boundary.hpp>
#include <riprap/dynamics/damping/no_damping.hpp>
#include <riprap/simulation/simulation.hpp>

namespace riprap::test {

/// With local damping, to come to rest. Forces are the law's at the middle of the chord, so that of
/// two faces is the stiffness times the depth.
template <ContactLaw Law>
[[nodiscard]] auto damped(const Law& law) {
  return Model{}
      .criterion(NeverFails{})
      .boundary(NoBoundary{})
      .narrow_phase(OverlapChord{})
      .contact_law(law)
      .time_step(MassFloor{.fraction = 0.12});
}

/// Without damping: what is left is Newton's law and the contact law.
template <ContactLaw Law>
[[nodiscard]] auto undamped(const Law& law) {
  return damped(law).damping(NoDamping{});
}

/// Linear springs of one stiffness [N/m] along and across the normal.
[[nodiscard]] inline LinearSpringCoulomb springs(double stiffness, double friction) {
  return {.normal_stiffness = stiffness, .tangential_stiffness = stiffness, .friction = friction};
}

/// A thickness of 1 m and a density in kg/m^3, so that mass is density times area.
[[nodiscard]] inline Assembly of(std::vector<PlacedParticle> particles) {
  return {.thickness = 1, .particles = std::move(particles)};
}
[[nodiscard]] inline Rock rock_of(double density) { return {.density = density}; }

}  // namespace riprap::test
