// SPDX-License-Identifier: BSL-1.0
// The geometry kernels, one call an iteration: polygons of 5 to 8 vertices, and of 3 to 5 in the
// names that end in /sharp. Input lies in the nearest caches; what a kernel costs when its polygons
// come from memory is not measured, nor is moving the vertices to the bodies' poses.

#include <riprap/geometry/overlap.hpp>
#include <riprap/geometry/polygon_properties.hpp>

#include "support.hpp"

namespace bench {
namespace {

// The polygon that two touching particles share.
template <const PolygonShape& shape>
void find_overlap(benchmark::State& state) {
  const std::vector<Pair> pairs = touching_pairs(shape);
  std::size_t i = 0;
  for (auto _ : state) {
    const auto& [a, b] = pairs[i++ % cycle];
    OverlapPolygon common = overlap(a, b, a[0], 1e-10 * size);
    benchmark::DoNotOptimize(common);
  }
}

// Particles apart, and the edge that parts them known from the step before: the usual case.
template <const PolygonShape& shape>
void separated_remembered(benchmark::State& state) {
  const std::vector<Pair> pairs = near_pairs(shape);
  std::vector<SeparatingEdge> memories(cycle);
  for (std::size_t k = 0; k < cycle; ++k)
    if (!separated(pairs[k][0], pairs[k][1], memories[k])) state.SkipWithError("a pair touches");
  std::size_t i = 0;
  for (auto _ : state) {
    const auto& [a, b] = pairs[i % cycle];
    bool apart = separated(a, b, memories[i++ % cycle]);
    benchmark::DoNotOptimize(apart);
  }
}

// The same with nothing known: the search for an edge that parts them.
template <const PolygonShape& shape>
void separated_search(benchmark::State& state) {
  const std::vector<Pair> pairs = near_pairs(shape);
  std::size_t i = 0;
  for (auto _ : state) {
    const auto& [a, b] = pairs[i++ % cycle];
    SeparatingEdge cache;
    bool apart = separated(a, b, cache);
    benchmark::DoNotOptimize(apart);
    benchmark::DoNotOptimize(cache);
  }
}

template <const PolygonShape& shape>
void find_minimum_translation(benchmark::State& state) {
  const std::vector<Pair> pairs = touching_pairs(shape);
  std::size_t i = 0;
  for (auto _ : state) {
    const auto& [a, b] = pairs[i++ % cycle];
    MinimumTranslation least = minimum_translation(a, b);
    benchmark::DoNotOptimize(least);
  }
}

// Area, centroid and polar moment.
template <const PolygonShape& shape>
void find_area_properties(benchmark::State& state) {
  const std::vector<Pair> pairs = touching_pairs(shape);
  std::size_t i = 0;
  for (auto _ : state) {
    AreaProperties properties = area_properties(pairs[i++ % cycle][0]);
    benchmark::DoNotOptimize(properties);
  }
}

BENCHMARK(find_overlap<blunt>)->Name("geometry/overlap");
BENCHMARK(find_overlap<sharp>)->Name("geometry/overlap/sharp");
BENCHMARK(separated_remembered<blunt>)->Name("geometry/separated_remembered");
BENCHMARK(separated_remembered<sharp>)->Name("geometry/separated_remembered/sharp");
BENCHMARK(separated_search<blunt>)->Name("geometry/separated_search");
BENCHMARK(separated_search<sharp>)->Name("geometry/separated_search/sharp");
BENCHMARK(find_minimum_translation<blunt>)->Name("geometry/minimum_translation");
BENCHMARK(find_minimum_translation<sharp>)->Name("geometry/minimum_translation/sharp");
BENCHMARK(find_area_properties<blunt>)->Name("geometry/area_properties");
BENCHMARK(find_area_properties<sharp>)->Name("geometry/area_properties/sharp");

}  // namespace
}  // namespace bench
