// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The mean stress in every particle, from the forces of its contacts.

#include <vector>

#include <riprap/core/stress2.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// Stress of every particle [Pa], averaged over its area, compression positive, in the order of the
/// bodies: sigma_ij = -1 / (A t) sum of x_i f_j, symmetric part, over the forces f on the particle
/// at arms x from its centroid. Weighted by area they add up to eq. 13 (average_stress). Exact for
/// a particle in equilibrium; zero for walls and platens.
template <class Contacts>
[[nodiscard]] std::vector<Stress2> contact_stresses(const Contacts& contacts,
                                                    const Particles& particles) {
  std::vector<Stress2> out(particles.size());
  const auto add = [&](BodyIndex i, const Vec2& x, const Vec2& f) {
    const double scale = -1 / (particles.shape(i).area * particles.thickness());
    out[i] += scale * symmetric_product(x, f);
  };
  contacts.for_each_touching([&](const auto& c) {
    add(c.a, c.branch_arm_a(), -c.force_on_b());
    add(c.b, c.branch_arm_b(), c.force_on_b());
  });
  return out;
}

}  // namespace riprap
