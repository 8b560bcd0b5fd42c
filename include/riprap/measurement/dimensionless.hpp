// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The dimensionless numbers that tell whether a run is quasi-static, stiff and stable.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include <riprap/core/exact_sum.hpp>
#include <riprap/core/linkage.hpp>
#include <riprap/dynamics/body_force/no_body_force.hpp>
#include <riprap/measurement/contact_sum.hpp>
#include <riprap/measurement/energy.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// Inertial number I = rate d sqrt(density / pressure) [-]; quasi-static below about 1e-3, infinite
/// where there is no pressure.
[[nodiscard]] double inertial_number(double strain_rate, double diameter, double density,
                                     double pressure);

/// Stiffness level kappa = pressure * thickness / normal stiffness [-]: about the overlap of
/// neighbours over their size.
[[nodiscard]] double stiffness_level(double pressure, double thickness, double normal_stiffness);

/// Time step over sqrt(m / k) of the lightest free body [-], with the mass that it has in the
/// equations of motion.
[[nodiscard]] double time_step_ratio(double time_step, const Particles& particles,
                                     double stiffness);

/// Means over the contacts and free bodies of one state.
struct StateAverages {
  std::size_t contacts = 0;
  double mean_normal_force = 0;  ///< [N]
  double unbalanced_force = 0;   ///< mean resultant on free bodies over mean contact force [-]
  double mean_overlap = 0;       ///< mean depth [m]
  double largest_overlap = 0;    ///< [m]
  double kinetic_energy = 0;     ///< of free bodies [J]
  double stored_energy = 0;      ///< in contacts and bonds [J]

  [[nodiscard]] double kinetic_ratio() const {
    return stored_energy > 0 ? kinetic_energy / stored_energy : 0;
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("contacts", self.contacts);
    visit("mean_normal_force", self.mean_normal_force);
    visit("unbalanced_force", self.unbalanced_force);
    visit("mean_overlap", self.mean_overlap);
    visit("largest_overlap", self.largest_overlap);
    visit("kinetic_energy", self.kinetic_energy);
    visit("stored_energy", self.stored_energy);
  }
};

/// @param body_force part of the resultant on a free body
/// @param bonds sum of the bond forces on each body; empty without bonds
template <class Contacts, BodyForce F = NoBodyForce>
[[nodiscard]] StateAverages state_averages(const Contacts& contacts, const Particles& particles,
                                           const F& body_force = {},
                                           std::span<const Wrench> bonds = {}) {
  StateAverages n;
  ContactSum<3> sums;
  contacts.for_each_touching([&](const auto& c) {
    ++n.contacts;
    sums.add(c.a, {c.force.normal, c.force_on_b().norm(), c.geometry.depth});
    n.largest_overlap = std::max(n.largest_overlap, c.geometry.depth);
  });
  const auto [normal, force, depth] = sums.values();
  std::size_t free = 0;
  ExactSum resultant;
  for (BodyIndex i = 0; i < particles.size(); ++i) {
    const Body& body = particles.body(i);
    if (!body.is_free()) continue;
    ++free;
    Vec2 sum = body.contact.force + body.mass * body_force(body);
    if (!bonds.empty()) sum += bonds[i].force;
    resultant.add(sum.norm());
  }
  n.mean_normal_force = normal;
  n.mean_overlap = depth;
  n.kinetic_energy = kinetic_energy(particles);
  n.stored_energy = stored_energy(contacts);
  if (n.contacts == 0 || free == 0) return n;
  const auto count = static_cast<double>(n.contacts);
  n.mean_normal_force /= count;
  n.mean_overlap /= count;
  n.unbalanced_force =
      force > 0 ? resultant.value() / static_cast<double>(free) / (force / count) : 0;
  return n;
}
/// Of a simulation; bonds belong to the resultants and to the stored energy.
template <class Sim>
  requires requires(const Sim& sim) { sim.body_force(); }
[[nodiscard]] StateAverages state_averages(const Sim& sim) {
  if constexpr (has_bonds<Sim>) {
    StateAverages n =
        state_averages(sim.contacts(), sim.particles(), sim.body_force(), sim.bonds().wrenches());
    n.stored_energy = stored_energy_of(sim);
    return n;
  } else {
    return state_averages(sim.contacts(), sim.particles(), sim.body_force());
  }
}

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/measurement/dimensionless.ipp>
#endif
