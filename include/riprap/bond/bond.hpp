// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A bond: the edge that two bodies have in common, and the tractions on it.

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <riprap/bond/bond_law/concepts.hpp>
#include <riprap/core/ids.hpp>
#include <riprap/core/vec2.hpp>
#include <riprap/particle/body.hpp>
#include <riprap/particle/domain.hpp>

namespace riprap {

/// Shares of the two ends of an edge at an integration point: Gauss's rule with two points, exact
/// for force, moment and energy of a traction that is linear along the edge.
inline constexpr double far_end_share = 0.5 - 0.5 * std::numbers::inv_sqrt3;
inline constexpr double near_end_share = 0.5 + 0.5 * std::numbers::inv_sqrt3;

/// Value at integration point g of what is linear along the edge.
/// @param ends its values at the two ends
template <class T>
[[nodiscard]] T at_point(const std::array<T, 2>& ends, std::size_t g) {
  return near_end_share * ends[g] + far_end_share * ends[1 - g];
}

/// Value at a share of the length of what is linear along the edge.
/// @param points its values at the two integration points
/// @param share of the length, from the first end on, in [0, 1]
template <class T>
[[nodiscard]] T at_share(const std::array<T, 2>& points, double share) {
  const double place = std::numbers::sqrt3 * (2 * share - 1);  // -1 and 1 at the points
  return 0.5 * ((1 - place) * points[0] + (1 + place) * points[1]);
}

/// An edge that a body has in common with another, in the body's own frame.
struct BondedEdge {
  std::array<Vec2, 2> ends{Vec2{0, 0}, Vec2{0, 0}};  ///< [m]
  Vec2 normal{1, 0};                                 ///< unit vector from a to b

  static void for_each_field(auto& self, auto&& visit) {
    visit("ends", self.ends);
    visit("normal", self.normal);
  }
};

/// Two bodies joined along an edge. A copy of the edge moves with each of them.
template <class StateT, class ImageT>
struct Bond {
  using State = StateT;
  using Image = ImageT;

  BodyIndex a = 0;  ///< a < b
  BodyIndex b = 0;
  [[no_unique_address]] Image image{};  ///< the copy of b that is joined to a, in a periodic domain
  MaterialIndex material_a = 0;         ///< of the bodies
  MaterialIndex material_b = 0;
  double length = 0;  ///< of the edge [m]
  BondedEdge on_a{};
  BondedEdge on_b{};
  BondView<State> view{};  ///< displacements, and states of the integration points
  Vec2 normal{1, 0};       ///< unit vector, half-way between those of the two edges
  /// Integration points, half-way between the two copies, minus the centroids [m].
  std::array<Vec2, 2> arms_a{Vec2{0, 0}, Vec2{0, 0}};
  std::array<Vec2, 2> arms_b{Vec2{0, 0}, Vec2{0, 0}};
  std::array<BondTraction, 2> tractions{};             ///< at the integration points
  std::array<Vec2, 2> forces{Vec2{0, 0}, Vec2{0, 0}};  ///< on b there [N]; a gets the opposite
  BondFailure failure = BondFailure::none;

  /// Force on b [N].
  [[nodiscard]] Vec2 force_on_b() const { return forces[0] + forces[1]; }
  /// Ends of the edge half-way between its two copies, at a [m].
  /// @param body_a body a
  [[nodiscard]] std::array<Vec2, 2> ends(const Body& body_a) const {
    const Vec2 half = 0.5 * std::numbers::sqrt3 * (arms_a[1] - arms_a[0]);
    return {middle(body_a) - half, middle(body_a) + half};
  }
  [[nodiscard]] Vec2 middle(const Body& body_a) const {
    return body_a.position + 0.5 * (arms_a[0] + arms_a[1]);
  }

  /// But for what follows from the poses of the bodies.
  static constexpr bool names_all_members = false;
  static void for_each_field(auto& self, auto&& visit) {
    visit("a", self.a);
    visit("b", self.b);
    visit("image", self.image);
    visit("material_a", self.material_a);
    visit("material_b", self.material_b);
    visit("length", self.length);
    visit("on_a", self.on_a);
    visit("on_b", self.on_b);
    visit("states", self.view.states);
  }
};

/// The law of a bond: that of its two materials, where the law of all bonds has one for them,
/// `law.of(material_a, material_b)`, the same in either order.
template <class BondType, BondLaw Law>
[[nodiscard]] const auto& law_of(const Law& law, const BondType& bond) {
  if constexpr (requires { law.of(bond.material_a, bond.material_b); })
    return law.of(bond.material_a, bond.material_b);
  else
    return law;
}

/// From b to the image of b that is joined to a [m].
template <class BondType, class Domain>
[[nodiscard]] Vec2 bond_offset(const BondType& bond, const Domain& domain) {
  if constexpr (Domain::periodic)
    return domain.offset(bond.image);
  else
    return {0, 0};
}

/// Displacements of the edge at the present poses of its bodies, resolved in axes half-way between
/// those of the two edges. These turn at the mean spin of the bodies, so that the rate of the
/// displacement in them is the relative velocity of the bodies at the point half-way between the
/// two copies. Forces that act there are the gradient of the bond's energy for any rotation, have
/// no moment in sum, and vanish under a rigid motion of the two.
/// @param offset from b to its image [m]
template <class BondType>
void find_displacements(BondType& bond, const Body& a, const Body& b, const Vec2& offset) {
  const Vec2 sum = a.rotation * bond.on_a.normal + b.rotation * bond.on_b.normal;
  const Vec2 normal = sum / std::sqrt(sum.dot(sum));
  const Vec2 between = b.position + offset - a.position;
  std::array<Vec2, 2> middle{Vec2{0, 0}, Vec2{0, 0}};  // minus the centroid of a
  for (std::size_t k = 0; k < 2; ++k) {
    const Vec2 at_a = a.rotation * bond.on_a.ends[k];
    const Vec2 at_b = between + b.rotation * bond.on_b.ends[k];
    const Vec2 apart = at_b - at_a;
    bond.view.ends[k] = {apart.dot(normal), apart.dot(perpendicular(normal))};
    middle[k] = 0.5 * (at_a + at_b);
  }
  bond.normal = normal;
  const std::array opening{bond.view.ends[0].opening, bond.view.ends[1].opening};
  const std::array sliding{bond.view.ends[0].sliding, bond.view.ends[1].sliding};
  for (std::size_t g = 0; g < 2; ++g) {
    bond.view.points[g] = {at_point(opening, g), at_point(sliding, g)};
    bond.arms_a[g] = at_point(middle, g);
    bond.arms_b[g] = bond.arms_a[g] - between;
  }
}

/// Tractions and forces of a bond at the displacements found, and whether it fails.
/// @param all the law of all bonds
/// @param thickness of the bodies [m]
/// @return energy lost [J]
template <class BondType, BondLaw Law>
double find_tractions(BondType& bond, const Law& all, double thickness) {
  const auto& law = law_of(all, bond);
  const double area = 0.5 * bond.length * thickness;
  const Vec2 tangent = perpendicular(bond.normal);
  double loss = 0;
  for (std::size_t g = 0; g < 2; ++g) {
    const BondTraction traction = law(bond.view.points[g], bond.view.states[g]);
    bond.tractions[g] = traction;
    bond.forces[g] = area * traction.normal * bond.normal + area * traction.tangential * tangent;
    loss += area * traction.loss;
  }
  bond.failure = law.failure(bond.view);
  return loss;
}

/// What a bond can give back [J].
template <class BondType, BondLaw Law>
[[nodiscard]] double stored_energy(const BondType& bond, const Law& all, double thickness) {
  const auto& law = law_of(all, bond);
  const double area = 0.5 * bond.length * thickness;
  return area * (law.stored_energy(bond.view.points[0], bond.view.states[0]) +
                 law.stored_energy(bond.view.points[1], bond.view.states[1]));
}

}  // namespace riprap
