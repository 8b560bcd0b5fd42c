// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// What a breakage pass works on.

#include <riprap/breakage/needs_elements.hpp>
#include <riprap/breakage/trigger/load_scale.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/material/rocks.hpp>
#include <riprap/particle/particles.hpp>
#include <riprap/stress/contact_loads.hpp>
#include <riprap/stress/particle_stress.hpp>

namespace riprap {

/// Policies and state of a simulation at one check for breakage.
template <class BreakagePart, class StressPart, ListedContacts Contacts, class Operators,
          Execution E>
struct BreakageInput {
  static constexpr bool needs_elements = riprap::needs_elements<BreakagePart>;
  static constexpr bool needs_loaded_particle = riprap::needs_loaded_particle<BreakagePart>;

  const BreakagePart& breakage;
  const StressPart& stress;
  const Rocks& rocks;
  double mean_area;  ///< of the intact particles [m^2]
  const Particles& particles;
  const Contacts& contacts;
  Operators& operators;  ///< state of the operator store
  const E& execution;

  /// A function that builds the operator of particle i.
  [[nodiscard]] auto builder(BodyIndex i) const {
    return [this, i] { return build_operator(stress, rock(i), particles, i); };
  }
  [[nodiscard]] const Rock& rock(BodyIndex i) const { return rocks[particles.material(i)]; }
  /// The criterion of particle i.
  [[nodiscard]] const auto& criterion(BodyIndex i) const {
    return criterion_of(breakage.criterion, particles.material(i));
  }
  [[nodiscard]] double scale(BodyIndex i) const {
    return load_scale(breakage.trigger, particles, i, rock(i));
  }
};

template <class B, class S, class C, class O, class E>
BreakageInput(const B&, const S&, const Rocks&, double, const Particles&, const C&, O&, const E&)
    -> BreakageInput<B, S, C, O, E>;

/// Runs `work`; names particle i if its input breaks a rule.
template <class Work>
void naming_particle(const Particles& particles, BodyIndex i, Work&& work) {
  try {
    work();
  } catch (const InvalidInput& error) {
    throw SimulationError(particle_text(particles.ancestry(i).id) + ": " + error.what());
  }
}

}  // namespace riprap
