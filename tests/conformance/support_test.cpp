// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <doctest/doctest.h>
#include <span>
#include <support/violated.hpp>

#include <riprap/conformance/support.hpp>
#include <riprap/stress/support/inertia_relief.hpp>
#include <riprap/stress/support/support_choice.hpp>
#include <riprap/stress/support/two_pinned_contacts.hpp>

using namespace riprap;
using test::check_violated;

namespace {

struct StrongContactsOnly {
  double share = 0.2;
  static constexpr bool needs_flexibility = false;
  void apply_reactions(std::span<BoundaryLoad> loads, const InfluenceOperator& /*op*/) const {
    double largest = 0;
    for (const BoundaryLoad& load : loads) largest = std::max(largest, load.normal_force);
    for (BoundaryLoad& load : loads)
      if (load.normal_force < share * largest) load.force_body = Vec2{0, 0};
  }
};

/// Does something to every load.
template <class Change>
struct Altered {
  static constexpr bool needs_flexibility = false;
  Change change;
  void apply_reactions(std::span<BoundaryLoad> loads, const InfluenceOperator&) const {
    for (BoundaryLoad& load : loads) change(load);
  }
};

template <class Change>
Altered<Change> altered(Change change) {
  return {change};
}

}  // namespace

TEST_CASE("the supports of riprap obey the axioms and keep the balance") {
  using Choice = TwoPinnedContacts::Choice;
  CHECK(to_text(support_violations(InertiaRelief{})) == "");
  CHECK(to_text(support_balance_violations(InertiaRelief{})) == "");
  for (const Choice choice : {Choice::largest_normal_forces, Choice::farthest_apart}) {
    CHECK(to_text(support_violations(TwoPinnedContacts{choice})) == "");
    CHECK(to_text(support_balance_violations(TwoPinnedContacts{choice})) == "");
  }
}

TEST_CASE("a choice of supports obeys the axioms and keeps the balance with each of them") {
  using Choice = SupportChoice<InertiaRelief, TwoPinnedContacts>;
  for (const Choice& chosen : {Choice{InertiaRelief{}}, Choice{TwoPinnedContacts{}}}) {
    CHECK(to_text(support_violations(chosen)) == "");
    CHECK(to_text(support_balance_violations(chosen)) == "");
  }
}

TEST_CASE("a user's support obeys the axioms, and may leave out loads") {
  CHECK(to_text(support_violations(StrongContactsOnly{})) == "");
  check_violated(support_balance_violations(StrongContactsOnly{}),
                 "forces in balance stay in balance: sum [N]");
}

TEST_CASE("a support that moves loads or adds some of its own is reported") {
  check_violated(support_violations(altered([](BoundaryLoad& l) { l.at.weight *= 0.9; })),
                 "loads stay where they act: way");
  check_violated(support_violations(altered([](BoundaryLoad& l) {
                   l.force_body += Vec2{1e-6, 0};
                 })),
                 "without loads there are no reactions");
}

TEST_CASE("a support with a force of its own is reported") {
  check_violated(support_violations(altered([](BoundaryLoad& l) {
                   if (l.normal_force < 100) l.force_body = Vec2{0, 0};
                 })),
                 "three times the loads have three times the reactions");
}

TEST_CASE("a support that turns the particle is reported") {
  check_violated(support_balance_violations(
                     altered([](BoundaryLoad& l) { l.force_body = perpendicular(l.force_body); })),
                 "moments in balance stay in balance: sum [N m]");
}

namespace {

struct Halves {
  static constexpr bool needs_flexibility = false;
  static constexpr bool is_linear() { return true; }
  void apply_reactions(std::span<BoundaryLoad> loads, const InfluenceOperator&) const {
    for (BoundaryLoad& load : loads) load.force_body *= 0.5;
  }
};

}  // namespace

TEST_CASE("a support that changes loads is not linear") {
  check_violated(support_violations(Halves{}),
                 "a linear support leaves the loads as they are: difference [N]");
}
