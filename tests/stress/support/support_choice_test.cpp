// SPDX-License-Identifier: BSL-1.0
#include <riprap/stress/support/support_choice.hpp>

#include <doctest/doctest.h>

#include <riprap/stress/support/inertia_relief.hpp>
#include <riprap/stress/support/two_pinned_contacts.hpp>
#include <support/loaded_particle.hpp>
#include <support/same_run.hpp>

using namespace riprap;

namespace {

using Choice = SupportChoice<InertiaRelief, TwoPinnedContacts>;
static_assert(Support<Choice>);
static_assert(Choice::needs_flexibility);
static_assert(!SupportChoice<InertiaRelief>::needs_flexibility);

}  // namespace

TEST_CASE("a chosen support balances loads as the support itself") {
  Random random(303);
  const Mesh mesh = test::random_mesh(random, 60);
  const InfluenceOperator op(mesh, ConstantStrainTriangle{}, PlaneStress{}, Rock{}, 0.016, true);
  const auto loads = test::random_loads(mesh, 5, random);
  const auto check_same = [&](const auto& support) {
    auto direct = loads;
    support.apply_reactions(direct, op);
    auto chosen = loads;
    Choice{support}.apply_reactions(chosen, op);
    for (std::size_t i = 0; i < loads.size(); ++i)
      CHECK(chosen[i].force_body == direct[i].force_body);
  };
  check_same(InertiaRelief{});
  check_same(TwoPinnedContacts{});
  check_same(TwoPinnedContacts{TwoPinnedContacts::Choice::farthest_apart});
}

TEST_CASE("a chosen support runs to the same bytes as the support itself") {
  const auto model = Model{}.trigger(FailedElementRatio{0.2});
  const auto relieved = test::run_of(model.support(InertiaRelief{}), 2000);
  const auto pinned = test::run_of(model.support(TwoPinnedContacts{}), 2000);
  CHECK(test::same_bytes(test::run_of(model.support(Choice{InertiaRelief{}}), 2000), relieved));
  CHECK(test::same_bytes(test::run_of(model.support(Choice{TwoPinnedContacts{}}), 2000), pinned));
  CHECK(!test::same_bytes(relieved, pinned));
}
