// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <riprap/stress/support/concepts.hpp>
#include <support/archetypes.hpp>

using namespace riprap;
namespace archetype = riprap::test::archetype;

namespace {

struct WithoutFlexibility : archetype::Support {
  void needs_flexibility() const {}
};
struct FlexibilityOfAnObject : archetype::Support {
  bool needs_flexibility = false;
};
struct WithoutSettle : archetype::Support {
  void apply_reactions() const {}
};
struct NotConst : archetype::Support {
  void apply_reactions(std::span<BoundaryLoad>, const InfluenceOperator&) {}
};
struct ChangesTheOperator : archetype::Support {
  void apply_reactions(std::span<BoundaryLoad>, InfluenceOperator&) const {}
};
struct ChangesTheSpan : archetype::Support {
  void apply_reactions(std::span<BoundaryLoad>&, const InfluenceOperator&) const {}
};

static_assert(Support<archetype::Support>);
static_assert(!Support<WithoutFlexibility>);
static_assert(!Support<FlexibilityOfAnObject>);
static_assert(!Support<WithoutSettle>);
static_assert(!Support<NotConst>);
static_assert(!Support<ChangesTheOperator>);
static_assert(!Support<ChangesTheSpan>);

struct HalfTheLoad {
  static constexpr bool needs_flexibility = false;
  void apply_reactions(std::span<BoundaryLoad> loads, const InfluenceOperator&) const {
    for (BoundaryLoad& load : loads) load.force_body *= 0.5;
  }
};

}  // namespace

TEST_CASE("a support need not look at the operator") { CHECK(Support<HalfTheLoad>); }
