// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The axioms of the bond law.

#include <algorithm>
#include <cmath>
#include <utility>

#include <riprap/bond/bond_law/concepts.hpp>
#include <riprap/conformance/violations.hpp>

namespace riprap {

/// For what a bond law is meant.
struct BondRange {
  double largest = 1e-4;  ///< displacement of the two edges [m]
};

namespace internal {

/// A path of displacements: pulled, slid, pushed together, slid the other way, and back, in small
/// steps that reach the largest displacement in the end.
inline constexpr int bond_path_steps = 20'000;
[[nodiscard]] inline BondDisplacement on_bond_path(const BondRange& range, int step) {
  const double share = static_cast<double>(step) / bond_path_steps;
  const double angle = 40 * share;  // more than six turns
  return {range.largest * share * std::cos(angle), range.largest * share * std::sin(angle)};
}

/// Tractions are minus the gradient of the energy at the state that they have led to.
template <BondLaw Law>
void check_bond_gradient(const Law& law, const BondDisplacement& d,
                         const typename Law::State& state, const BondTraction& traction,
                         const BondRange& range, AxiomCheck& check) {
  const double step = 1e-5 * range.largest;
  if (std::abs(d.opening) <= step || std::abs(d.sliding) <= step) return;  // may have a kink there
  const auto slope = [&](double opening, double sliding) {
    return (law.stored_energy({d.opening + opening, d.sliding + sliding}, state) -
            law.stored_energy({d.opening - opening, d.sliding - sliding}, state)) /
           (2 * step);
  };
  const double tolerance = 1e-4 * law.peak_stiffness() * range.largest;
  check.equal("the normal traction is minus the gradient of the energy", traction.normal,
              -slope(step, 0), tolerance);
  check.equal("the tangential traction is minus the gradient of the energy", traction.tangential,
              -slope(0, step), tolerance);
}

}  // namespace internal

/// Which axioms a bond law breaks, along one path of displacements.
template <BondLaw Law>
[[nodiscard]] Violations bond_law_violations(const Law& law, const BondRange& range = {}) {
  AxiomCheck check;
  const double large = law.peak_stiffness() * range.largest;
  check.at_least("the peak stiffness is not negative", law.peak_stiffness(), 0);
  typename Law::State state{}, of_mirrored{};
  const BondTraction nothing = law(BondDisplacement{}, state);
  check.equal("no displacement, no normal traction", nothing.normal, 0, 0);
  check.equal("no displacement, no tangential traction", nothing.tangential, 0, 0);
  check.equal("no displacement, no energy", law.stored_energy(BondDisplacement{}, state), 0, 0);
  check.holds("a new bond holds",
              law.failure(BondView<typename Law::State>{}) == BondFailure::none);
  BondTraction before{};
  double work = 0, lost = 0, energy = 0, unexplained = 0;  // [J/m^2]
  for (int n = 1; n <= internal::bond_path_steps; ++n) {
    const BondDisplacement last = internal::on_bond_path(range, n - 1);
    const BondDisplacement d = internal::on_bond_path(range, n);
    const BondTraction traction = law(d, state);
    const double stored = law.stored_energy(d, state);
    check.at("opening", d.opening);
    check.holds("tractions are finite", std::isfinite(traction.normal + traction.tangential));
    check.at_least("damage never gives energy", traction.loss, 0);
    check.at_least("stored energy is never negative", stored, 0);
    check.at_most("the normal traction is at most the peak stiffness times the opening",
                  std::abs(traction.normal),
                  law.peak_stiffness() * std::abs(d.opening) + 1e-12 * large);
    check.at_most("the tangential traction is at most the peak stiffness times the sliding",
                  std::abs(traction.tangential),
                  law.peak_stiffness() * std::abs(d.sliding) + 1e-12 * large);
    const BondTraction again = law(d, state);
    check.equal("evaluated again, the normal traction stays", again.normal, traction.normal,
                1e-12 * large);
    check.equal("evaluated again, the tangential traction stays", again.tangential,
                traction.tangential, 1e-12 * large);
    check.equal("evaluated again, nothing is lost", again.loss, 0, 0);
    const BondTraction mirrored = law({d.opening, -d.sliding}, of_mirrored);
    check.equal("mirrored displacements give mirrored tractions", mirrored.tangential,
                -traction.tangential, 1e-12 * large);
    if (n % 16 == 0) internal::check_bond_gradient(law, d, state, traction, range, check);
    work -= 0.5 * ((before.normal + traction.normal) * (d.opening - last.opening) +
                   (before.tangential + traction.tangential) * (d.sliding - last.sliding));
    lost += traction.loss;
    energy = std::max(energy, stored + lost);
    unexplained = std::max(unexplained, std::abs(stored + lost - work));
    before = traction;
  }
  check.at_most("work done on a bond is stored or lost: the rest [J/m^2]", unexplained,
                50.0 / internal::bond_path_steps * energy);
  return std::move(check).violations();
}

}  // namespace riprap
