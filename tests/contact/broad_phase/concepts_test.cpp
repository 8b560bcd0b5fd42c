// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <riprap/contact/broad_phase/concepts.hpp>
#include <support/archetypes.hpp>

using namespace riprap;
namespace archetype = riprap::test::archetype;

namespace {

struct WithoutSkin : archetype::BroadPhase {
  void relative_skin() const {}
};
struct WithoutPairs : archetype::BroadPhase {
  void visit_pairs() const {}
};
struct ChangesItself : archetype::BroadPhase {
  void visit_pairs(std::span<const Box>, auto&&) {}
};
struct ChangesTheBoxes : archetype::BroadPhase {
  void visit_pairs(std::span<Box>, auto&&) const {}
};
struct KnowsItsVisitor : archetype::BroadPhase {
  void visit_pairs(std::span<const Box>, void (*)(BodyIndex, BodyIndex)) const {}
};
struct SkinIsNoNumber : archetype::BroadPhase {
  Vec2 relative_skin{0, 0};
};
struct ChangesTheSpan : archetype::BroadPhase {
  void visit_pairs(std::span<const Box>&, auto&&) const {}
};

struct WithWorkspace : archetype::BroadPhase {
  struct Workspace {};
  using archetype::BroadPhase::visit_pairs;
  void visit_pairs(std::span<const Box>, Workspace&, auto&&) const {}
};
struct WorkspaceForNothing : archetype::BroadPhase {
  struct Workspace {};
};

static_assert(BroadPhase<archetype::BroadPhase>);
static_assert(BroadPhase<WithWorkspace>);
static_assert(!BroadPhase<WorkspaceForNothing>);
static_assert(!BroadPhase<WithoutSkin>);
static_assert(!BroadPhase<WithoutPairs>);
static_assert(!BroadPhase<ChangesItself>);
static_assert(!BroadPhase<ChangesTheBoxes>);
static_assert(!BroadPhase<KnowsItsVisitor>);
static_assert(!BroadPhase<SkinIsNoNumber>);
static_assert(!BroadPhase<ChangesTheSpan>);

}  // namespace

TEST_CASE("boxes overlap if they share a point, in either order") {
  const Box unit{{0, 0}, {1, 1}};
  const auto both_ways = [&unit](const Box& other) {
    CHECK(unit.overlaps(other) == other.overlaps(unit));
    return unit.overlaps(other);
  };
  CHECK(both_ways(unit));
  CHECK(both_ways({{0.2, 0.2}, {0.3, 0.3}}));  // inside
  CHECK(both_ways({{-1, 0.4}, {2, 0.5}}));     // across
  CHECK(both_ways({{0.5, 0.5}, {3, 3}}));      // corner in corner
  CHECK(both_ways({{1, 1}, {2, 2}}));          // one point
  CHECK(!both_ways({{1.1, 0}, {2, 1}}));       // right
  CHECK(!both_ways({{-2, 0}, {-0.1, 1}}));     // left
  CHECK(!both_ways({{0, 1.1}, {1, 2}}));       // above
  CHECK(!both_ways({{0, -2}, {1, -0.1}}));     // below
}
