// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/contact_law/contact_law_choice.hpp>

#include <doctest/doctest.h>

#include <riprap/contact/contact_law/linear_spring_coulomb.hpp>
#include <riprap/contact/contact_law/no_contact_force.hpp>
#include <riprap/contact/contact_law/overlap_area_spring.hpp>
#include <riprap/contact/contact_law/spring_dashpot.hpp>
#include <support/message_of.hpp>
#include <support/same_run.hpp>

using namespace riprap;

namespace {

using Choice =
    ContactLawChoice<LinearSpringCoulomb, SpringDashpot, OverlapAreaSpring, NoContactForce>;
static_assert(ContactLaw<Choice>);

const ContactGeometry geometry{.depth = 1e-5, .area = 1e-8, .chord = 1e-3};
constexpr ContactMotion sliding{
    .normal_velocity = -0.1, .tangential_velocity = 0.2, .time_step = 1e-6, .effective_mass = 0.01};

template <class Law>
void check_same(const Law& law) {
  const Choice choice{law};
  Choice::History history;
  typename Law::History own;
  for (int i = 0; i < 3; ++i) {
    const ContactForce chosen = choice(geometry, sliding, history);
    const ContactForce direct = law(geometry, sliding, own);
    CHECK(chosen.normal == direct.normal);
    CHECK(chosen.tangential == direct.tangential);
    CHECK(chosen.friction_loss == direct.friction_loss);
    CHECK(chosen.viscous_loss == direct.viscous_loss);
    CHECK(choice.stored_energy(geometry, history) == law.stored_energy(geometry, own));
  }
  CHECK(choice.peak_stiffness() == law.peak_stiffness());
}

}  // namespace

TEST_CASE("a chosen contact law gives the same bits as the law itself") {
  check_same(LinearSpringCoulomb{.normal_stiffness = 1e7, .friction = 0.1});
  check_same(SpringDashpot{.damping_ratio = 0.4, .may_pull = true});
  check_same(OverlapAreaSpring{.area_stiffness = 1e12});
  check_same(NoContactForce{});
}

TEST_CASE("a chosen contact law runs to the same bytes as the law itself") {
  const auto run = [](const auto& law) { return test::run_of(Model{}.contact_law(law), 1500); };
  CHECK(test::same_bytes(run(Choice{LinearSpringCoulomb{}}), run(LinearSpringCoulomb{})));
  CHECK(test::same_bytes(run(Choice{SpringDashpot{}}), run(SpringDashpot{})));
  CHECK(test::same_bytes(run(Choice{OverlapAreaSpring{}}), run(OverlapAreaSpring{})));
  CHECK(!test::same_bytes(run(Choice{LinearSpringCoulomb{}}), run(Choice{SpringDashpot{}})));
}

TEST_CASE("a contact loses its history when another law is chosen") {
  Choice::History history;
  const Choice first{LinearSpringCoulomb{}};
  CHECK(first(geometry, sliding, history).tangential != 0);
  const Choice second{SpringDashpot{}};
  // Stored: the normal spring alone, before and after the force is evaluated.
  const double normal = SpringDashpot{}.stored_energy(geometry, {});
  CHECK(second.stored_energy(geometry, history) == normal);
  CHECK(second(geometry, {}, history).tangential == 0);
  CHECK(second.stored_energy(geometry, history) == normal);
  // Nor does the first law find its own again.
  CHECK(first(geometry, {}, history).tangential == 0);
}

TEST_CASE("a choice without friction is the chosen law without friction") {
  const Choice smooth = frictionless(Choice{SpringDashpot{.damping_ratio = 0.3, .may_pull = true}});
  const auto& law = std::get<SpringDashpot>(smooth.chosen);
  CHECK(law.friction == 0);
  CHECK(law.damping_ratio == 0.3);
  CHECK(law.may_pull);
  CHECK(std::holds_alternative<NoContactForce>(frictionless(Choice{NoContactForce{}}).chosen));
}

TEST_CASE("a choice validates the chosen contact law") {
  CHECK_NOTHROW(Choice{NoContactForce{}}.validate());
  CHECK(test::message_of([] { Choice{SpringDashpot{.damping_ratio = 1}}.validate(); }) ==
        "SpringDashpot.damping_ratio = 1: must lie in [0, 1)");
}
