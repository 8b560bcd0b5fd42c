// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Contacts and bonds as one: all forces between the bodies.

#include <array>
#include <cstddef>

#include <riprap/bond/bond.hpp>
#include <riprap/contact/pair/contact.hpp>
#include <riprap/contact/pair/pair_index.hpp>
#include <riprap/contact/pair/pair_map.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// The force of a part of a bond, with the names that a contact has.
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

/// In how many parts of its length a bond loads its bodies. The traction is linear between its two
/// integration points and beyond them; each part has a force at both points of Gauss's rule, so
/// that force and moment of the bond are exact, and a uniform traction stays one for a fine mesh.
inline constexpr std::size_t bond_load_parts = 8;

/// Calls `visit(force)` for the forces of a bond along its edge.
template <class BondType, class Visit>
void for_each_force(const BondType& bond, const Particles& particles, Visit&& visit) {
  constexpr double parts = bond_load_parts;
  const Vec2 tangent = perpendicular(bond.normal);
  for (std::size_t part = 0; part < bond_load_parts; ++part)
    for (std::size_t g = 0; g < 2; ++g) {
      const std::array shares{static_cast<double>(part) / parts,
                              static_cast<double>(part + 1) / parts};
      const double share = at_point(shares, g);
      const Vec2 on_b = at_share(bond.forces, share) / parts;
      const Vec2 arm_a = at_share(bond.arms_a, share);
      visit(BondForce{bond.a,
                      bond.b,
                      {particles.body(bond.a).position + arm_a},
                      {bond.normal.dot(on_b), tangent.dot(on_b)},
                      arm_a,
                      at_share(bond.arms_b, share),
                      on_b});
    }
}

/// Contacts, then bonds, for measurements of stress and for the loads of a particle: what these
/// take from a contact list.
template <class Contacts, class Bonds>
class Interactions {
 public:
  Interactions(const Contacts& contacts, const Bonds& bonds, const Particles& particles)
      : contacts_(contacts), bonds_(bonds), particles_(particles) {}

  /// Calls `visit(force)` for every contact that touches, then for the forces of every bond.
  template <class Visit>
  void for_each_touching(Visit&& visit) const {
    contacts_.for_each_touching(visit);
    for (const auto& bond : bonds_) for_each_force(bond, particles_, visit);
  }
  /// Calls `visit(force, is_b)` for the forces of every bond of body i.
  template <class Visit>
  void for_each_bond_force_on(BodyIndex i, Visit&& visit) const {
    for (const PairSide side : bonds_.index().of(i))
      for_each_force(bonds_[side.pair()], particles_,
                     [&](const BondForce& force) { visit(force, side.is_b()); });
  }

  // Of the contacts alone.

  [[nodiscard]] const auto& domain() const { return contacts_.domain(); }
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
