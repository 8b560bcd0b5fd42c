// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// What a simulation keeps for its bonds.

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <riprap/bond/bond_law/no_bonds.hpp>
#include <riprap/bond/bond_list.hpp>
#include <riprap/bond/bond_stiffness.hpp>
#include <riprap/bond/components.hpp>
#include <riprap/bond/interactions.hpp>
#include <riprap/contact/former_bonds.hpp>
#include <riprap/particle/assembly.hpp>
#include <riprap/simulation/body_step.hpp>
#include <riprap/simulation/bond_break.hpp>

namespace riprap {

/// Pairs without contact in a model with a bond law.
template <class Law, class Domain>
using PairsWithoutContact =
    std::conditional_t<makes_bonds<Law>, ExcludedPairs<typename Domain::Image>, NoExcludedPairs>;

/// When something happens.
struct Moment {
  std::uint64_t step = 0;
  double time = 0;  ///< [s]
};

/// Without bonds: nothing.
template <class Law, class Domain>
struct BondStage {
  explicit BondStage(const Law&) {}
  void begin(const Assembly&, Particles&, const Domain&) {}
  static void exclude(auto&) {}
  static constexpr double stiffness(const Particles&, double) { return 0; }
  static constexpr NoBondForces wrenches() { return {}; }
  static void add_image_work(BodyIndex, BodyIndex, const Domain&, double, ExactSum&) {}
  template <class Contacts, Execution E>
  static void update(const Particles&, Contacts&, const Moment&, const E&, bool) {}
  static void add_body(const Particles&) {}
  static void divide(const DividedBody&, const Particles&, const Domain&, const Moment&) {}
  static void exclude_divided(auto&) {}
  static void remove(BodyIndex, const Particles&, auto&) {}
  [[nodiscard]] static const auto& interactions(const auto& contacts, const Particles&) {
    return contacts;
  }
  static void restore(const Particles&, auto&) {}
};

/// The list of bonds, and the record of those that have broken.
template <class Law, class Domain>
  requires makes_bonds<Law>
struct BondStage<Law, Domain> {
  using Bonds = BondList<Law, Domain>;
  using BondType = typename Bonds::BondType;

  explicit BondStage(const Law& law) : bonds(law) {}

  /// Adds the bonds of the assembly. Bonded particles become parts of one: they have one root.
  void begin(const Assembly& assembly, Particles& particles, const Domain& domain) {
    bonds.add(assembly.bonds, particles, domain);
    Components clusters(particles.size());
    for (const BondType& bond : bonds) clusters.join(bond.a, bond.b);
    for (BodyIndex i = 0; i < particles.size(); ++i)
      particles.set_root(i, particles.ancestry(clusters.of(i)).id);
  }
  template <class Contacts>
  void exclude(Contacts& contacts) const {
    contacts.exclude(bonds.pairs());
  }
  [[nodiscard]] double stiffness(const Particles& particles, double mass) const {
    return equivalent_stiffness(bonds, particles, mass);
  }
  [[nodiscard]] std::span<const Wrench> wrenches() const { return bonds.wrenches(); }
  void add_image_work(BodyIndex first, BodyIndex last, const Domain& domain, double time,
                      ExactSum& work) const {
    bonds.add_image_work(first, last, domain, time, work);
  }

  /// Tractions at the present poses. Bonds that fail are gone, and the contacts of their pairs, at
  /// the same poses, begin with the next update of the contacts.
  /// @param may_fail false: none does
  template <class Contacts, Execution E>
  void update(const Particles& particles, Contacts& contacts, const Moment& now, const E& execution,
              bool may_fail) {
    gone_.clear();
    bonds.update(particles, contacts.domain(), gone_, execution, may_fail);
    if (!gone_.empty()) part(particles, contacts, now);
  }
  /// Breaks the bonds of which `is_broken(bond)` is true.
  template <class Contacts, class IsBroken>
  void break_if(const Particles& particles, Contacts& contacts, const Moment& now,
                IsBroken&& is_broken) {
    gone_.clear();
    bonds.take_out(particles.size(), gone_, is_broken);
    if (!gone_.empty()) part(particles, contacts, now);
  }
  /// A body without bonds has come, behind the others.
  void add_body(const Particles& particles) { bonds.resize(particles.size()); }
  /// Body i was removed, with its bonds; those behind it have moved up.
  template <class Contacts>
  void remove(BodyIndex i, const Particles& particles, Contacts& contacts) {
    gone_.clear();
    bonds.take_out(particles.size() + 1, gone_,
                   [i](const BondType& bond) { return bond.a == i || bond.b == i; });
    bonds.remove(i, particles.size());
    exclude(contacts);
  }
  /// Hands the bonds of a particle that has broken to its pieces; those of dust are broken.
  /// `exclude_divided` must come when all particles have broken.
  void divide(const DividedBody& broken, const Particles& particles, const Domain& domain,
              const Moment& now) {
    gone_.clear();
    if (bonds.divide(broken, particles, domain, gone_)) divided_ = true;
    if (gone_.empty()) return;
    const auto other_of = [&](const BondType& bond) {
      return bond.a == broken.parent ? bond.b : bond.a;
    };
    const std::size_t first = breaks.size();
    for (const BondType& bond : gone_) {
      const BodyIndex other = other_of(bond);
      const Body& a = bond.a == broken.parent ? broken.whole : particles.body(bond.a);
      breaks.push_back({.step = now.step,
                        .time = now.time,
                        .particles = {particles.ancestry(other).id, no_particle},
                        .place = bond.middle(a),
                        .ends = bond.a == other ? bond.on_a.ends : bond.on_b.ends,
                        .length = bond.length,
                        .energy = stored_energy(bond, bonds.law(), particles.thickness())});
      bonds.add_loss(breaks.back().energy);
    }
    // Dust is one more body. What it was cut off from is separated by the break of the particle.
    const auto dust = static_cast<BodyIndex>(particles.size());
    Components joined(particles.size() + 1);
    for (const std::optional<BodyIndex>& piece : broken.pieces)
      if (piece) joined.join(*piece, dust);
    find_separations(joined, first, [&](const BondType& bond) {
      return std::pair{other_of(bond), dust};
    });
  }
  /// Leaves the pairs of bonds of pieces out, if there are any: all pairs are to be found anew.
  template <class Contacts>
  void exclude_divided(Contacts& contacts) {
    if (std::exchange(divided_, false)) exclude(contacts);
  }
  [[nodiscard]] auto interactions(const auto& contacts, const Particles& particles) const {
    return Interactions{contacts, bonds, particles};
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("bonds", self.bonds);
    visit("breaks", self.breaks);
    visit("told", self.told);
  }
  /// After the fields have been written, and before the contacts are restored.
  template <class Contacts>
  void restore(const Particles& particles, Contacts& contacts) {
    bonds.restore(particles, contacts.domain());
    exclude(contacts);
  }

  Bonds bonds;
  std::vector<BondBreak> breaks;
  std::size_t told = 0;  ///< of them, to observers

 private:
  // Hands the pairs of the bonds in `gone_`, which are in order, over to the contacts.
  template <class Contacts>
  void part(const Particles& particles, Contacts& contacts, const Moment& now) {
    const double thickness = particles.thickness();
    const std::size_t first = breaks.size();
    former_.clear();
    event_of_.clear();
    exclude(contacts);
    const auto bonded = bonds.pairs();
    for (const BondType& bond : gone_) {
      if (!bonded.contains(bond.a, bond.b, bond.image)) add_former(bond, thickness);
      breaks.push_back({.step = now.step,
                        .time = now.time,
                        .particles = {particles.ancestry(bond.a).id, particles.ancestry(bond.b).id},
                        .failure = bond.failure,
                        .place = bond.middle(particles.body(bond.a)),
                        .ends = bond.on_a.ends,
                        .length = bond.length,
                        .energy = stored_energy(bond, bonds.law(), thickness)});
    }
    contacts.begin_contacts(
        particles, std::span<const FormerPair<typename BondType::Image>>(former_),
        [&](std::size_t n, double energy) { breaks[first + event_of_[n]].energy -= energy; });
    for (std::size_t k = first; k < breaks.size(); ++k) bonds.add_loss(breaks[k].energy);
    Components joined(particles.size());
    find_separations(joined, first, [](const BondType& bond) { return std::pair{bond.a, bond.b}; });
  }

  void add_former(const BondType& bond, double thickness) {
    const bool known = !former_.empty() && former_.back().a == bond.a &&
                       former_.back().b == bond.b && former_.back().image == bond.image;
    if (!known) {
      former_.push_back({bond.a, bond.b, bond.image});
      event_of_.push_back(static_cast<std::size_t>(&bond - gone_.data()));
    }
    FormerBond& left = former_.back().bond;
    const auto& law = law_of(bonds.law(), bond);
    const double area = 0.5 * bond.length * thickness;
    for (std::size_t g = 0; g < 2; ++g) {
      const auto& [opening, sliding] = bond.view.points[g];
      const auto& state = bond.view.states[g];
      left.normal_force += area * std::max(0.0, bond.tractions[g].normal);
      left.normal_energy +=
          area * law.stored_energy(BondDisplacement{std::min(opening, 0.0), 0}, state);
      left.tangential_force += area * bond.tractions[g].tangential;
      left.tangential_energy += area * law.stored_energy(BondDisplacement{0, sliding}, state);
    }
  }

  // In the order of the breaks from `first` on: which of them leave two bodies that no chain of
  // bonds joins. Those that break later are put back first. `ends_of(bond)` are the bodies of one
  // in `gone_`.
  template <class EndsOf>
  void find_separations(Components& joined, std::size_t first, EndsOf&& ends_of) {
    for (const BondType& bond : bonds) joined.join(bond.a, bond.b);
    for (std::size_t k = gone_.size(); k-- > 0;) {
      const auto [a, b] = ends_of(gone_[k]);
      breaks[first + k].separates = joined.join(a, b);
    }
  }

  bool divided_ = false;  // a particle with bonds has broken since `exclude_divided`
  std::vector<BondType> gone_;
  std::vector<FormerPair<typename BondType::Image>> former_;
  std::vector<std::size_t> event_of_;  // of each of them, from the first of these breaks on
};

}  // namespace riprap
