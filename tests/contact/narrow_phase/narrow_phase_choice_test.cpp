// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/narrow_phase/narrow_phase_choice.hpp>

#include <doctest/doctest.h>

#include <riprap/contact/narrow_phase/overlap_chord.hpp>
#include <riprap/contact/narrow_phase/overlap_moments.hpp>
#include <riprap/contact/narrow_phase/separating_axis.hpp>
#include <support/same_run.hpp>

using namespace riprap;

namespace {

using Choice = NarrowPhaseChoice<OverlapMoments, OverlapChord, SeparatingAxis>;
static_assert(NarrowPhase<Choice>);
static_assert(!BatchedNarrowPhase<Choice>);

}  // namespace

TEST_CASE("a chosen narrow phase runs to the same bytes as the narrow phase itself") {
  const auto run = [](const auto& narrow) {
    return test::run_of(Model{}.narrow_phase(narrow), 1500);
  };
  CHECK(test::same_bytes(run(Choice{OverlapMoments{}}), run(OverlapMoments{})));
  CHECK(test::same_bytes(run(Choice{OverlapChord{}}), run(OverlapChord{})));
  CHECK(test::same_bytes(run(Choice{SeparatingAxis{}}), run(SeparatingAxis{})));
  CHECK(!test::same_bytes(run(Choice{OverlapMoments{}}), run(Choice{OverlapChord{}})));
}

TEST_CASE("a pair forgets what it has cached for another narrow phase") {
  constexpr double gap = 0.5;
  const ConvexPolygon a{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const ConvexPolygon b = a.moved({}, {1 + gap, 0});
  Choice::Cache cache;
  const Choice moments{OverlapMoments{}};
  CHECK(!moments(a.ring(), b.ring(), cache));
  const double clearance = moments.clearance(cache);
  CHECK(clearance > 0);
  CHECK(clearance <= gap);
  CHECK(Choice{OverlapChord{}}.clearance(cache) == 0);
}
