// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/narrow_phase/classified_overlap.hpp>

#include <doctest/doctest.h>

#include <optional>

#include <riprap/contact/narrow_phase/concepts.hpp>
#include <support/overlapping_pairs.hpp>
#include <support/rectangle.hpp>

using namespace riprap;
using test::rectangle;
using test::tip_down;

namespace {

// Reports the class by the depth.
struct ByClass : ClassifiedOverlap<ByClass> {
  template <class N>
  using Edge = internal::CornerEdgeOverlaps<N>;
  template <class N>
  using Corners = internal::CornerCornerOverlaps<N>;
  static ContactGeometry of_edge(const CornerEdgeOverlap& cap, double sign) {
    return {.normal = sign * cap.normal, .depth = 1};
  }
  static ContactGeometry of_corners(const CornerCornerOverlap&) { return {.depth = 2}; }
  static ContactGeometry of_common_part(Ring, Ring, const CommonPart&) { return {.depth = 3}; }
};
static_assert(NarrowPhase<ByClass> && BatchedNarrowPhase<ByClass>);

using State = ByClass::Cache::State;

}  // namespace

TEST_CASE("each class of overlap goes to its own formula, and is kept") {
  const ConvexPolygon square = rectangle({0, 0}, 1, 1);
  struct Case {
    ConvexPolygon other;
    double depth;
    State state;
  };
  for (const auto& [other, depth, state] :
       {Case{tip_down({0.1, 0.4}, 1, 0.8), 1, State::corner_edge},
        Case{rectangle({0.1, 0.7}, 0.5, 0.5), 1, State::corner_edge},
        Case{rectangle({0.9, 0.9}, 1, 1), 2, State::corner_corner},
        Case{rectangle({0.1, 0.4}, 4, 0.04), 3, State::general},
        Case{rectangle({0.1, 0.1}, 0.2, 0.2), 3, State::general}}) {
    ByClass::Cache cache;
    for (int again = 0; again < 2; ++again) {
      const auto contact = ByClass{}(square.ring(), other.ring(), cache);
      REQUIRE(contact);
      CHECK(contact->depth == depth);
      CHECK(cache.state == state);
    }
    const auto swapped = ByClass{}(other.ring(), square.ring(), cache);
    REQUIRE(swapped);
    CHECK(swapped->depth == depth);
  }
}

TEST_CASE("a class that holds no longer is found anew") {
  const ConvexPolygon square = rectangle({0, 0}, 1, 1);
  ByClass::Cache cache;
  const auto state_at = [&](const ConvexPolygon& other) {
    (void)ByClass{}(square.ring(), other.ring(), cache);
    return cache.state;
  };
  CHECK(state_at(rectangle({0.1, 0.7}, 0.5, 0.5)) == State::corner_edge);
  CHECK(state_at(rectangle({0.6, 0.7}, 0.5, 0.5)) == State::corner_corner);
  CHECK(state_at(rectangle({0.1, 0.9}, 0.5, 0.5)) == State::apart);
  CHECK(ByClass{}.clearance(cache) > 0.1);
  CHECK(state_at(rectangle({0.1, 0.7}, 0.5, 0.5)) == State::corner_edge);
}
