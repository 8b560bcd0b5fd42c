// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// No bonds: the default, and the file to copy for a law of your own.

#include <concepts>

#include <riprap/bond/bond_law/concepts.hpp>

namespace riprap {

/// A model without bonds; nothing of them is compiled into a step.
struct NoBonds {
  struct State {
    static void for_each_field(auto&, auto&&) {}
  };

  [[nodiscard]] BondTraction operator()(const BondDisplacement&, State&) const { return {}; }
  [[nodiscard]] double stored_energy(const BondDisplacement&, const State&) const { return 0; }
  [[nodiscard]] BondFailure failure(const BondView<State>&) const { return BondFailure::none; }
  [[nodiscard]] double peak_stiffness() const { return 0; }

  static void for_each_field(auto&, auto&&) {}
};

static_assert(BondLaw<NoBonds>);

/// Whether a law makes bonds.
template <class L>
inline constexpr bool makes_bonds = !std::same_as<L, NoBonds>;

}  // namespace riprap
