// SPDX-License-Identifier: BSL-1.0
#include <riprap/acceleration/screening/stress_bound_screening.hpp>
#include <riprap/contact/contact_law/linear_spring_coulomb.hpp>

#include <doctest/doctest.h>

#include <span>

#include <riprap/acceleration/operator_cache.hpp>
#include <riprap/stress/support/support_choice.hpp>
#include <riprap/stress/support/two_pinned_contacts.hpp>
#include <support/breakage_passes.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

// Counts calls of failed_elements_needed: one for every particle that is screened.
struct CountingTrigger : FailedElementRatio {
  int* asked = nullptr;
  std::size_t failed_elements_needed(std::size_t elements) const {
    ++*asked;
    return FailedElementRatio::failed_elements_needed(elements);
  }
};

}  // namespace

TEST_CASE("a particle far from breaking is evaluated once while its loads stay as they are") {
  int asked = 0;
  CountingTrigger trigger;
  trigger.asked = &asked;
  const auto model = Model{}.trigger(trigger);
  // A hundredth of the forces that break the squares.
  const Simulation sim{model.contact_law(LinearSpringCoulomb{.normal_stiffness = 2e5}), crushed,
                       Rock{}};
  Pass pass(model);
  const auto find = [&] { return pass.find(sim).size(); };
  CHECK(find() == 0);
  CHECK(asked == 2);
  CHECK(find() == 0);
  CHECK(asked == 2);
  // Another particle in the same place is unknown.
  pass.stage.forget(3);
  CHECK(find() == 0);
  CHECK(asked == 3);
}

namespace {

// How often a pass over the crushed squares screens a particle under a support.
template <class Support>
int screened(const Support& support) {
  int asked = 0;
  CountingTrigger trigger;
  trigger.asked = &asked;
  const auto model = Model{}.trigger(trigger).support(support);
  const Simulation sim{model.contact_law(LinearSpringCoulomb{.normal_stiffness = 2e5}), crushed,
                       Rock{}};
  Pass pass(model);
  CHECK(pass.find(sim).empty());
  return asked;
}

// A user's support that leaves the loads as they are.
struct FreeFlight {
  static constexpr bool needs_flexibility = false;
  void apply_reactions(std::span<BoundaryLoad>, const InfluenceOperator&) const {}
  bool is_linear() const { return true; }
};

}  // namespace

TEST_CASE("particles are screened under every support that is linear, and under no other") {
  using Choice = SupportChoice<InertiaRelief, TwoPinnedContacts>;
  static_assert(LinearSupport<InertiaRelief> && LinearSupport<FreeFlight>);
  static_assert(!LinearSupport<TwoPinnedContacts>);
  CHECK(screened(InertiaRelief{}) == 2);
  CHECK(screened(FreeFlight{}) == 2);
  CHECK(screened(TwoPinnedContacts{}) == 0);
  CHECK(screened(Choice{InertiaRelief{}}) == 2);
  CHECK(screened(Choice{TwoPinnedContacts{}}) == 0);
}
