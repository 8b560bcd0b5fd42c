// SPDX-License-Identifier: BSL-1.0
#include <riprap/acceleration/batching/batched_detection.hpp>

#include <doctest/doctest.h>

#include <optional>
#include <vector>

#include <support/rectangle.hpp>

using namespace riprap;
using test::rectangle;

namespace {

// Squares of side 1 in a row; counts the evaluations.
struct Counting {
  struct Cache {
    double gap = 0;
  };
  int* evaluations;
  std::optional<ContactGeometry> operator()(Ring a, Ring b, Cache& cache) const {
    ++*evaluations;
    cache.gap = std::abs(b[0].x() - a[0].x()) - 1;
    if (cache.gap > 0) return std::nullopt;
    return ContactGeometry{.depth = -cache.gap};
  }
  [[nodiscard]] double clearance(const Cache& cache) const { return cache.gap; }
};

// Bodies have approached each other by `moved`.
struct Bound {
  double moved = 0;
  [[nodiscard]] double displacement() const { return moved; }
  [[nodiscard]] double contact_threshold(double gap) const { return moved + 0.5 * gap; }
};

}  // namespace

TEST_CASE("a separated pair is skipped until its bodies can have closed the gap") {
  Particles particles(1, 2500);
  for (const double x : {0.0, 0.9, 2.1}) particles.add(rectangle({x, 0}, 1, 1), Motion::free);
  using Pair = Contact<int, Counting::Cache>;
  std::vector<Pair> pairs{{.a = 0, .b = 1}, {.a = 1, .b = 2}};
  int evaluations = 0;
  const Counting narrow{&evaluations};
  BatchedDetection::State<Counting> state;
  PairMap map;
  map.begin();
  map.add(PairMap::not_present);
  map.add(PairMap::not_present);
  map.finish(1);
  state.carry(map);
  const auto evaluations_at = [&](double moved) {
    const Bound bound{moved};
    const UnboundedDomain domain;
    const DetectionInput<Pair, Counting, UnboundedDomain, Bound> input{pairs, particles, narrow,
                                                                       domain, bound};
    ContactTask task{.last_body = 3, .last_pair = 2};
    evaluations = 0;
    state.find(input, task);
    CHECK(task.touching == std::vector<std::uint32_t>{0});
    return evaluations;
  };
  CHECK(evaluations_at(0) == 2);
  // The gap is 0.2: skipped until half of it is covered.
  CHECK(evaluations_at(0.099) == 1);
  CHECK(evaluations_at(0.101) == 2);
  CHECK(evaluations_at(0.101) == 1);
  state.forget(1);
  CHECK(evaluations_at(0.101) == 2);
  state.forget_all();
  CHECK(evaluations_at(0.101) == 2);
}
