// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/detection/evaluate_each_pair.hpp>

#include <doctest/doctest.h>

#include <vector>

#include <riprap/contact/narrow_phase/overlap_chord.hpp>
#include <support/rectangle.hpp>

using namespace riprap;
using test::rectangle;

TEST_CASE("every pair of the task is evaluated with an empty cache") {
  Particles particles(1, 2500);
  for (const double x : {0.0, 0.99, 2.5}) particles.add(rectangle({x, 0}, 1, 1), Motion::free);
  using Pair = Contact<int, OverlapChord::Cache, PeriodicDomain::Image>;
  std::vector<Pair> pairs{{.a = 0, .b = 1},
                          {.a = 0, .b = 2, .image = {-1, 0}, .crosses_boundary = true},
                          {.a = 1, .b = 2}};
  // A cache that would be wrong if it were used.
  pairs[2].cache.state = OverlapChord::Cache::State::general;
  pairs[2].touching = true;
  const RebuildEveryStep::State<PeriodicDomain> list;
  const PeriodicDomain domain{.period = {3.49, 10}};
  const OverlapChord narrow;
  const DetectionInput<Pair, OverlapChord, PeriodicDomain, RebuildEveryStep::State<PeriodicDomain>>
      input{pairs, particles, narrow, domain, list};
  ContactTask task{.last_body = 3, .last_pair = 3};
  EvaluateEachPair::State<OverlapChord>{}.find(input, task);
  CHECK(task.touching == std::vector<std::uint32_t>{0, 1});
  CHECK(task.crossing == std::vector<std::uint32_t>{1});
  CHECK_FALSE(pairs[2].touching);
}
