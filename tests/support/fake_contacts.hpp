// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Contacts put together by hand, for measurements that need no simulation.

#include <vector>

#include <riprap/contact/contact_law/linear_spring_coulomb.hpp>
#include <riprap/contact/contact_list.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap::test {

struct NoMemory {};

/// The record of a real contact list.
using FakeContact = Contact<LinearSpringCoulomb::History, NoMemory>;

/// The functions of a contact list that measurements call.
struct FakeContacts {
  std::vector<FakeContact> list;
  LinearSpringCoulomb contact_law{};
  double lost_in_slip = 0;
  double lost_in_dashpots = 0;

  template <class Visit>
  void for_each_touching(Visit&& visit) const {
    for (const FakeContact& contact : list) visit(contact);
  }
  [[nodiscard]] const LinearSpringCoulomb& law() const { return contact_law; }
  [[nodiscard]] Vec2 relative_velocity(const FakeContact& c, const Particles& particles) const {
    return particles.body(c.b).velocity_at(c.arm_b) - particles.body(c.a).velocity_at(c.arm_a);
  }
  [[nodiscard]] double friction_loss() const { return lost_in_slip; }
  [[nodiscard]] double viscous_loss() const { return lost_in_dashpots; }
};

/// A contact between bodies at `position_a` and `position_b`, with its point half way.
[[nodiscard]] inline FakeContact fake_contact(BodyIndex a, BodyIndex b, const Vec2& position_a,
                                              const Vec2& position_b, const Vec2& normal,
                                              double normal_force, double tangential_force) {
  FakeContact contact;
  contact.a = a;
  contact.b = b;
  contact.touching = true;
  contact.geometry.normal = normal;
  contact.geometry.point = 0.5 * (position_a + position_b);
  contact.force.normal = normal_force;
  contact.force.tangential = tangential_force;
  contact.history.tangential_force = tangential_force;
  contact.arm_a = contact.geometry.point - position_a;
  contact.arm_b = contact.geometry.point - position_b;
  return contact;
}

/// The same contact with the two bodies exchanged.
[[nodiscard]] inline FakeContact exchanged(FakeContact contact) {
  std::swap(contact.a, contact.b);
  std::swap(contact.arm_a, contact.arm_b);
  contact.geometry.normal = -contact.geometry.normal;
  return contact;
}

}  // namespace riprap::test
