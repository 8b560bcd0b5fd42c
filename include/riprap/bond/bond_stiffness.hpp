// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The stiffness of bonds as the time-step rule wants it.

#include <algorithm>
#include <cstddef>
#include <vector>

#include <riprap/bond/bond.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// A bound on the highest frequency w of the bonds alone, as the stiffness [N/m] of a chain of
/// equal masses m that has it, w^2 = 4 k / m:
///
///     w^2 <= 2 max over free bodies i of sum over integration points of k_g (1 / m_i + r_g^2 /
///     I_i)
///
/// with k_g the stiffness of half of a bond and r_g the arm of its integration point. For k_g |u_a
/// - u_b|^2 <= 2 k_g (|u_a|^2 + |u_b|^2), and the displacement u of a point of body i that moves by
/// q and turns by p obeys |u|^2 <= (1 / m_i + r_g^2 / I_i) (m_i q^2 + I_i p^2). Masses are those of
/// the equations of motion.
/// @param mass m [kg]
template <class Bonds>
[[nodiscard]] double equivalent_stiffness(const Bonds& bonds, const Particles& particles,
                                          double mass) {
  std::vector<double> squared(particles.size(), 0);
  const double peak = bonds.law().peak_stiffness();
  const auto add = [&](BodyIndex i, const Vec2& arm, double stiffness) {
    const Body& body = particles.body(i);
    if (!body.is_free()) return;
    squared[i] += 2 * stiffness * (1 / body.mass + arm.dot(arm) / body.inertia) / body.mass_scaling;
  };
  for (const auto& bond : bonds) {
    const double stiffness = 0.5 * peak * bond.length * particles.thickness();
    for (std::size_t g = 0; g < 2; ++g) {
      add(bond.a, bond.arms_a[g], stiffness);
      add(bond.b, bond.arms_b[g], stiffness);
    }
  }
  const auto highest = std::max_element(squared.begin(), squared.end());
  return highest == squared.end() ? 0 : 0.25 * mass * *highest;
}

}  // namespace riprap
