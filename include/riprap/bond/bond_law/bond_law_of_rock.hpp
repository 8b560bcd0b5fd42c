// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Bonds of several rocks: a bond law for each material, and one for bonds between two.

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <riprap/bond/bond_law/concepts.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/core/ids.hpp>
#include <riprap/core/policy.hpp>

namespace riprap {

/// Holds bond laws of one type, in the order of the simulation's list of rocks.
///
///     Model{}.bond_law(BondLawOfRock<BrittleBond>{.laws = {strong, weak}, .between = weak})
template <BondLaw L>
struct BondLawOfRock {
  using State = typename L::State;

  std::vector<L> laws;  ///< of bonds between particles of one material
  L between{};          ///< of bonds between particles of two

  [[nodiscard]] const L& of(MaterialIndex a, MaterialIndex b) const {
    return a == b ? laws[a] : between;
  }
  [[nodiscard]] std::size_t materials() const { return laws.size(); }

  // Without materials: the law of the first one.
  [[nodiscard]] BondTraction operator()(const BondDisplacement& d, State& state) const {
    return laws.front()(d, state);
  }
  [[nodiscard]] double stored_energy(const BondDisplacement& d, const State& state) const {
    return laws.front().stored_energy(d, state);
  }
  [[nodiscard]] BondFailure failure(const BondView<State>& bond) const {
    return laws.front().failure(bond);
  }
  [[nodiscard]] double peak_stiffness() const {
    double peak = between.peak_stiffness();
    for (const L& law : laws) peak = std::max(peak, static_cast<double>(law.peak_stiffness()));
    return peak;
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("laws", self.laws);
    visit("between", self.between);
  }

  /// Throws InvalidInput for an empty list and for a law that breaks a rule, with its place.
  void validate() const {
    if (laws.empty()) throw InvalidInput("BondLawOfRock.laws is empty");
    for (std::size_t k = 0; k < laws.size(); ++k)
      validate_named("bond law of material " + std::to_string(k), laws[k]);
    validate_named("bond law between two materials", between);
  }
};

}  // namespace riprap
