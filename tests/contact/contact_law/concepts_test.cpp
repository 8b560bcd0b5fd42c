// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <riprap/contact/contact_law/concepts.hpp>
#include <support/archetypes.hpp>

using namespace riprap;
namespace archetype = riprap::test::archetype;

namespace {

class WithoutHistory : public archetype::ContactLaw {
  using archetype::ContactLaw::History;  // private
};
struct HistoryThatMustBeMade : archetype::ContactLaw {
  struct History {
    explicit History(int) {}
  };
  ContactForce operator()(const ContactGeometry&, const ContactMotion&, History&) const {
    return {};
  }
  double stored_energy(const ContactGeometry&, const History&) const { return 0; }
};
struct NotConst : archetype::ContactLaw {
  ContactForce operator()(const ContactGeometry&, const ContactMotion&, History&) { return {}; }
};
struct BareNumberForForce : archetype::ContactLaw {
  double operator()(const ContactGeometry&, const ContactMotion&, History&) const { return 0; }
};
struct ChangesTheGeometry : archetype::ContactLaw {
  ContactForce operator()(ContactGeometry&, const ContactMotion&, History&) const { return {}; }
};
struct WithoutEnergy : archetype::ContactLaw {
  void stored_energy() const {}
};
struct EnergyChangesTheHistory : archetype::ContactLaw {
  double stored_energy(const ContactGeometry&, History&) const { return 0; }
};
struct WithoutStiffness : archetype::ContactLaw {
  void peak_stiffness() const {}
};
struct ChangesTheMotion : archetype::ContactLaw {
  ContactForce operator()(const ContactGeometry&, ContactMotion&, History&) const { return {}; }
};
struct EnergyIsNotConst : archetype::ContactLaw {
  double stored_energy(const ContactGeometry&, const History&) { return 0; }
};
struct EnergyIsNoNumber : archetype::ContactLaw {
  Vec2 stored_energy(const ContactGeometry&, const History&) const { return {0, 0}; }
};
struct EnergyChangesTheGeometry : archetype::ContactLaw {
  double stored_energy(ContactGeometry&, const History&) const { return 0; }
};
struct StiffnessIsNotConst : archetype::ContactLaw {
  double peak_stiffness() { return 1; }
};

struct FrictionlessNotConst : archetype::ContactLaw {
  FrictionlessNotConst frictionless() { return *this; }
};
static_assert(!ContactLaw<FrictionlessNotConst>);
static_assert(ContactLaw<archetype::ContactLaw>);
static_assert(!ContactLaw<WithoutHistory>);
static_assert(!ContactLaw<HistoryThatMustBeMade>);
static_assert(!ContactLaw<NotConst>);
static_assert(!ContactLaw<BareNumberForForce>);
static_assert(!ContactLaw<ChangesTheGeometry>);
static_assert(!ContactLaw<WithoutEnergy>);
static_assert(!ContactLaw<EnergyChangesTheHistory>);
static_assert(!ContactLaw<WithoutStiffness>);
static_assert(!ContactLaw<ChangesTheMotion>);
static_assert(!ContactLaw<EnergyIsNotConst>);
static_assert(!ContactLaw<EnergyIsNoNumber>);
static_assert(!ContactLaw<EnergyChangesTheGeometry>);
static_assert(!ContactLaw<StiffnessIsNotConst>);

}  // namespace

TEST_CASE("a contact force starts from zero, and so does a contact motion") {
  constexpr ContactForce force;
  CHECK(force.normal == 0);
  CHECK(force.tangential == 0);
  CHECK(force.friction_loss == 0);
  CHECK(force.viscous_loss == 0);
  constexpr ContactMotion motion;
  CHECK(motion.time_step == 0);
  CHECK(motion.tangential_velocity == 0);
}
