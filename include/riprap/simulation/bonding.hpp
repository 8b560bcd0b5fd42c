// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// What a simulation says of its bonds, and how a program breaks them.

#include <vector>

#include <riprap/simulation/body_settings.hpp>
#include <riprap/simulation/bond_stage.hpp>
#include <riprap/simulation/observer.hpp>

namespace riprap {

template <class Sim>
class Breaking;

/// Base of a Simulation.
template <class Sim>
class Bonding {
 public:
  /// The live bonds, in the order of their bodies (a, b, image), for models with a bond law.
  [[nodiscard]] const auto& bonds() const { return sim().bonds_.bonds; }
  /// All bonds that have broken since the start, in order.
  [[nodiscard]] const std::vector<BondBreak>& bond_breaks() const { return sim().bonds_.breaks; }
  /// Force [N] of all bonds on body i and its moment about the centroid [N m]; `force_on` is that
  /// of the contacts.
  [[nodiscard]] Wrench bond_force_on(BodyIndex i) const {
    require_body(sim().particles(), i);
    if constexpr (Sim::bonded)
      return bonds().wrenches()[i];
    else
      return {};
  }
  /// Contacts, with the bonds if there are any: what the stress in the sample is made of.
  [[nodiscard]] decltype(auto) interactions() const {
    return sim().bonds_.interactions(sim().contacts(), sim().particles());
  }
  /// Between steps: breaks the bonds of which `is_broken(bond)` is true; their energy is lost. The
  /// observers of the next step are told.
  template <class IsBroken>
  void break_bonds(IsBroken&& is_broken) {
    sim().bonds_.break_if(sim().particles_, sim().contacts_, {sim().steps_, sim().time_},
                          is_broken);
    sim().contacts_.update(sim().particles_, 0, sim().model_.execution_policy);
  }

 private:
  friend Sim;
  friend class Breaking<Sim>;
  Bonding() = default;
  [[nodiscard]] Sim& sim() { return static_cast<Sim&>(*this); }
  [[nodiscard]] const Sim& sim() const { return static_cast<const Sim&>(*this); }

  template <class... Observers>
  void tell_bond_breaks([[maybe_unused]] Observers&... observers) {
    if constexpr (Sim::bonded)
      for (auto& told = sim().bonds_.told; told < bond_breaks().size(); ++told)
        (hooks::on_bond_break(observers, sim(), bond_breaks()[told]), ...);
  }
};

}  // namespace riprap
