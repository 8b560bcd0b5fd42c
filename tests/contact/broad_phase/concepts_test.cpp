#include <doctest/doctest.h>

#include <riprap/contact/broad_phase/concepts.hpp>

using namespace riprap;

namespace {

// The least a broad phase may be.
struct Minimal {
  double relative_skin = 0;
  template <class Visit>
  void visit_pairs(std::span<const Box>, Visit&&) const {}
  void validate() const {}
};

struct WithoutRules {
  double relative_skin = 0;
  template <class Visit>
  void visit_pairs(std::span<const Box>, Visit&&) const {}
};

struct WithoutSkin {
  template <class Visit>
  void visit_pairs(std::span<const Box>, Visit&&) const {}
  void validate() const {}
};

struct WithoutPairs {
  double relative_skin = 0;
  void validate() const {}
};

struct ChangesItself {
  double relative_skin = 0;
  template <class Visit>
  void visit_pairs(std::span<const Box>, Visit&&) {}
  void validate() const {}
};

static_assert(BroadPhase<Minimal>);
static_assert(!BroadPhase<WithoutRules>);
static_assert(!BroadPhase<WithoutSkin>);
static_assert(!BroadPhase<WithoutPairs>);
static_assert(!BroadPhase<ChangesItself>);

}  // namespace

TEST_CASE("boxes meet if they share a point, whichever is asked") {
  const Box unit{{0, 0}, {1, 1}};
  const auto both_ways = [&unit](const Box& other) {
    CHECK(unit.meets(other) == other.meets(unit));
    return unit.meets(other);
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
