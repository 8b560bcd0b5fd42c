// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Two neighbours and, while they touch, their contact.

#include <riprap/contact/pair/contact_geometry.hpp>
#include <riprap/core/ids.hpp>
#include <riprap/core/vec2.hpp>
#include <riprap/particle/body.hpp>
#include <riprap/particle/domain.hpp>

namespace riprap {

/// Components of a contact force in the frame of the contact.
struct ForceComponents {
  double normal = 0;      ///< along the normal [N], pushing: positive
  double tangential = 0;  ///< along the tangent [N]

  static void for_each_field(auto& self, auto&& visit) {
    visit("normal", self.normal);
    visit("tangential", self.tangential);
  }
};

/// A pair of neighbours and, while they touch, their contact.
template <class History, class Cache, class Image = UnboundedDomain::Image>
struct Contact {
  BodyIndex a = 0;  ///< a < b
  BodyIndex b = 0;
  [[no_unique_address]] Image image{};  ///< the copy of b in contact with a, in a periodic domain
  bool touching = false;
  // These follow from the bodies and the image, by `know_bodies`.
  bool at_platen = false;  ///< one of the two is a platen
  bool a_is_wall = false;  ///< a wall or a platen
  bool b_is_wall = false;
  bool crosses_boundary = false;  ///< of the periodic cell: `image` is not b itself
  Cache cache{};
  // Meaningful only while touching.
  ContactGeometry geometry{};
  History history{};
  ForceComponents force{};
  /// Contact point minus centroid of a, when the force was evaluated [m]; zero for a platen, whose
  /// contact carries no moment.
  Vec2 arm_a{0, 0};
  Vec2 arm_b{0, 0};

  /// Sets what follows from the bodies and the image.
  void know_bodies(const Body& body_a, const Body& body_b) {
    crosses_boundary = image != Image{};
    at_platen = body_a.motion == Motion::platen || body_b.motion == Motion::platen;
    a_is_wall = body_a.is_wall();
    b_is_wall = body_b.is_wall();
  }

  /// Force on b [N]; a gets the opposite.
  [[nodiscard]] Vec2 force_on_b() const {
    using namespace internal;
    const TwoDoubles n = pair_of(geometry.normal);  // vectorised
    return vec2_of(n * force.normal + swapped(n) * TwoDoubles{-force.tangential, force.tangential});
  }
  [[nodiscard]] bool at_wall() const { return a_is_wall || b_is_wall; }
  /// The arms without that on a wall, whose centroid is no part of the sample [m].
  [[nodiscard]] Vec2 branch_arm_a() const { return a_is_wall ? Vec2{0, 0} : arm_a; }
  [[nodiscard]] Vec2 branch_arm_b() const { return b_is_wall ? Vec2{0, 0} : arm_b; }
  /// From the centroid of a to that of b; at a wall from or to the contact point [m].
  [[nodiscard]] Vec2 branch() const { return branch_arm_a() - branch_arm_b(); }

  /// But for the cache, on which no result depends, and what `know_bodies` sets.
  static constexpr bool names_all_members = false;
  static void for_each_field(auto& self, auto&& visit) {
    visit("a", self.a);
    visit("b", self.b);
    visit("image", self.image);
    visit("touching", self.touching);
    visit("geometry", self.geometry);
    visit("history", self.history);
    visit("force", self.force);
    visit("arm_a", self.arm_a);
    visit("arm_b", self.arm_b);
  }
};

}  // namespace riprap
