// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Bonds that soften linearly with a fracture energy.

#include <algorithm>
#include <cmath>

#include <riprap/bond/bond_law/concepts.hpp>
#include <riprap/core/errors.hpp>

namespace riprap {

/// A cohesive law with scalar damage d in each integration point, which never heals: the energy is
/// (1 - d) W for opening and sliding, W = (k_n opening^2 + k_s sliding^2) / 2, and k_n opening^2 /
/// 2 undamaged where the edges overlap. Damage starts where the point (k_n opening / tensile
/// strength, k_s sliding / shear strength) leaves the unit circle, and the traction then falls
/// linearly with the displacement; under a proportional displacement in any direction the whole
/// fracture energy is dissipated per area, exactly, whatever the steps. An effective displacement
/// with a weight for sliding, as Camacho and Ortiz (1996, Int. J. Solids Struct. 33); one fracture
/// energy for all modes.
///
/// The bond is gone when both points are fully damaged. Its shear strength does not depend on the
/// pressure; friction begins with the contact that takes its place.
struct SofteningBond {
  double normal_stiffness = 2.5e11;      ///< k_n [Pa/m]
  double tangential_stiffness = 2.5e11;  ///< k_s [Pa/m]
  double tensile_strength = 10e6;        ///< [Pa]
  double shear_strength = 20e6;          ///< [Pa]
  double fracture_energy = 2000;         ///< [J/m^2]

  struct State {
    double damage = 0;  ///< d [-]

    static void for_each_field(auto& self, auto&& visit) { visit("damage", self.damage); }
  };

  [[nodiscard]] BondTraction operator()(const BondDisplacement& d, State& state) const {
    const double loss = grow(d, state);
    const double left = 1 - state.damage;
    return {.normal = -normal_stiffness * (d.opening > 0 ? left * d.opening : d.opening),
            .tangential = -left * tangential_stiffness * d.sliding,
            .loss = loss};
  }
  [[nodiscard]] double stored_energy(const BondDisplacement& d, const State& state) const {
    const double overlap = std::min(d.opening, 0.0);
    return (1 - state.damage) * undamaged_energy(d) + 0.5 * normal_stiffness * overlap * overlap;
  }
  [[nodiscard]] BondFailure failure(const BondView<State>& bond) const {
    for (const State& state : bond.states)
      if (state.damage < 1) return BondFailure::none;
    const BondDisplacement& d = bond.points[0];
    return open(d) >= std::abs(slid(d)) ? BondFailure::tension : BondFailure::shear;
  }
  [[nodiscard]] double peak_stiffness() const {
    return std::max(normal_stiffness, tangential_stiffness);
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("normal_stiffness", self.normal_stiffness);
    visit("tangential_stiffness", self.tangential_stiffness);
    visit("tensile_strength", self.tensile_strength);
    visit("shear_strength", self.shear_strength);
    visit("fracture_energy", self.fracture_energy);
  }

  void validate() const {
    require_positive("SofteningBond.normal_stiffness", normal_stiffness);
    require_positive("SofteningBond.tangential_stiffness", tangential_stiffness);
    require_positive("SofteningBond.tensile_strength", tensile_strength);
    require_positive("SofteningBond.shear_strength", shear_strength);
    require(fracture_energy > 0.5 * tensile_strength * tensile_strength / normal_stiffness,
            "SofteningBond.fracture_energy", fracture_energy,
            "must be above tensile_strength^2 / (2 normal_stiffness)");
    require(fracture_energy > 0.5 * shear_strength * shear_strength / tangential_stiffness,
            "SofteningBond.fracture_energy", fracture_energy,
            "must be above shear_strength^2 / (2 tangential_stiffness)");
  }

 private:
  // Displacements over those at the strengths.
  [[nodiscard]] double open(const BondDisplacement& d) const {
    return normal_stiffness * std::max(d.opening, 0.0) / tensile_strength;
  }
  [[nodiscard]] double slid(const BondDisplacement& d) const {
    return tangential_stiffness * d.sliding / shear_strength;
  }
  [[nodiscard]] double undamaged_energy(const BondDisplacement& d) const {
    const double opening = std::max(d.opening, 0.0);
    return 0.5 *
           (normal_stiffness * opening * opening + tangential_stiffness * d.sliding * d.sliding);
  }

  // Brings the damage up to the displacement; returns what that dissipates [J/m^2].
  double grow(const BondDisplacement& d, State& state) const {
    const double now = std::sqrt(open(d) * open(d) + slid(d) * slid(d));  // 1: damage starts
    if (now <= 1 || state.damage >= 1) return 0;
    const double last = fracture_energy / (undamaged_energy(d) / (now * now));  // no traction left
    const double damage = now >= last ? 1 : last * (now - 1) / (now * (last - 1));
    if (damage <= state.damage) return 0;
    const double before = last / (last - state.damage * (last - 1));
    state.damage = damage;
    return fracture_energy / (last - 1) * (std::min(now, last) - before);
  }
};

static_assert(BondLaw<SofteningBond>);

}  // namespace riprap
