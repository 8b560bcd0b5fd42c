// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Contacts and bonds as one: all forces between the bodies.

#include <cstddef>

#include <riprap/bond/bond.hpp>
#include <riprap/contact/pair/contact.hpp>
#include <riprap/contact/pair/pair_index.hpp>
#include <riprap/contact/pair/pair_map.hpp>

namespace riprap {

/// The force of a bond at one of its integration points, with the names that a contact has.
struct BondForce {
  struct Place {
    Vec2 point{0, 0};  ///< half-way between the two edges, at a [m]
  };
  BodyIndex a = 0;
  BodyIndex b = 0;
  Place geometry{};
  ForceComponents force{};
  Vec2 arm_a{0, 0};
  Vec2 arm_b{0, 0};
  Vec2 on_b{0, 0};  ///< [N]

  [[nodiscard]] Vec2 force_on_b() const { return on_b; }
  [[nodiscard]] Vec2 branch_arm_a() const { return arm_a; }
  [[nodiscard]] Vec2 branch_arm_b() const { return arm_b; }
  [[nodiscard]] Vec2 branch() const { return arm_a - arm_b; }
};

/// @param g one of the two integration points of a bond
template <class BondType>
[[nodiscard]] BondForce force_of(const BondType& bond, std::size_t g, const Particles& particles) {
  const Vec2& on_b = bond.forces[g];
  return {bond.a,
          bond.b,
          {particles.body(bond.a).position + bond.arms_a[g]},
          {bond.normal.dot(on_b), perpendicular(bond.normal).dot(on_b)},
          bond.arms_a[g],
          bond.arms_b[g],
          on_b};
}

/// Contacts, then bonds, for measurements of stress and for the loads of a particle: what these
/// take from a contact list.
template <class Contacts, class Bonds>
class Interactions {
 public:
  Interactions(const Contacts& contacts, const Bonds& bonds, const Particles& particles)
      : contacts_(contacts), bonds_(bonds), particles_(particles) {}

  /// Calls `visit(force)` for every contact that touches, then for the two points of every bond.
  template <class Visit>
  void for_each_touching(Visit&& visit) const {
    contacts_.for_each_touching(visit);
    for (const auto& bond : bonds_)
      for (std::size_t g = 0; g < 2; ++g) visit(force_of(bond, g, particles_));
  }
  /// Calls `visit(force, is_b)` for the two points of every bond of body i.
  template <class Visit>
  void for_each_bond_force_on(BodyIndex i, Visit&& visit) const {
    for (const PairSide side : bonds_.index().of(i))
      for (std::size_t g = 0; g < 2; ++g)
        visit(force_of(bonds_[side.pair()], g, particles_), side.is_b());
  }

  // Of the contacts alone.

  [[nodiscard]] auto pairs() const { return contacts_.pairs(); }
  [[nodiscard]] const PairMap& map() const { return contacts_.map(); }
  [[nodiscard]] const PairIndex& index() const { return contacts_.index(); }
  template <class Visit>
  void for_each_touching_of(std::size_t task, Visit&& visit) const {
    contacts_.for_each_touching_of(task, visit);
  }

 private:
  const Contacts& contacts_;
  const Bonds& bonds_;
  const Particles& particles_;
};

}  // namespace riprap
