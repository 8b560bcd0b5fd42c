#include <doctest/doctest.h>

#include <riprap/contact/law/concepts.hpp>

using namespace riprap;

namespace {

// The least a contact law may be.
struct Minimal {
  struct History {};
  ContactForce operator()(const ContactGeometry&, const ContactMotion&, History&) const {
    return {};
  }
  double stored_energy(const ContactGeometry&, const History&) const { return 0; }
  double peak_stiffness() const { return 1; }
  void validate() const {}
};

struct WithoutHistory {
  ContactForce operator()(const ContactGeometry&, const ContactMotion&, int&) const { return {}; }
  double stored_energy(const ContactGeometry&, int) const { return 0; }
  double peak_stiffness() const { return 1; }
  void validate() const {}
};

struct WithoutEnergy {
  struct History {};
  ContactForce operator()(const ContactGeometry&, const ContactMotion&, History&) const {
    return {};
  }
  double peak_stiffness() const { return 1; }
  void validate() const {}
};

struct WithoutStiffness {
  struct History {};
  ContactForce operator()(const ContactGeometry&, const ContactMotion&, History&) const {
    return {};
  }
  double stored_energy(const ContactGeometry&, const History&) const { return 0; }
  void validate() const {}
};

struct BareNumberForForce {
  struct History {};
  double operator()(const ContactGeometry&, const ContactMotion&, History&) const { return 0; }
  double stored_energy(const ContactGeometry&, const History&) const { return 0; }
  double peak_stiffness() const { return 1; }
  void validate() const {}
};

static_assert(ContactLaw<Minimal>);
static_assert(!ContactLaw<WithoutHistory>);
static_assert(!ContactLaw<WithoutEnergy>);
static_assert(!ContactLaw<WithoutStiffness>);
static_assert(!ContactLaw<BareNumberForForce>);

}  // namespace

TEST_CASE("a contact force starts from zero, and so does a contact motion") {
  constexpr ContactForce force;
  CHECK(force.normal == 0);
  CHECK(force.tangential == 0);
  CHECK(force.slipped == 0);
  CHECK(force.damped == 0);
  constexpr ContactMotion motion;
  CHECK(motion.time_step == 0);
  CHECK(motion.tangential_velocity == 0);
}
