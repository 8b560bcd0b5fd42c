// SPDX-License-Identifier: BSL-1.0
#pragma once
// What several benchmarks need: polygons, pairs of them, and a counter.

#include <benchmark/benchmark.h>

#include <array>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <riprap/geometry/random_polygon.hpp>
#include <riprap/geometry/separation.hpp>

namespace bench {

using namespace riprap;

inline constexpr double size = 0.016;  // of a particle [m]

// Two kinds of polygon. Names without an ending are of the first, those with /sharp of the second.
inline constexpr PolygonShape blunt{.fewest_vertices = 5, .most_vertices = 8};
inline constexpr PolygonShape sharp{};

// Kernels take other input every time, in a cycle too long for a branch predictor to learn by
// heart. A power of two.
inline constexpr std::size_t cycle = 1024;

// Time [s] for one of the `count` things that an iteration does.
inline void count_time(benchmark::State& state, const std::string& thing, double count) {
  using benchmark::Counter;
  state.counters["time/" + thing] =
      Counter(count, Counter::kIsIterationInvariantRate | Counter::kInvert);
}

using Pair = std::array<std::vector<Vec2>, 2>;

[[nodiscard]] inline std::vector<Vec2> shifted(Ring ring, const Vec2& by) {
  std::vector<Vec2> out(ring.begin(), ring.end());
  for (Vec2& v : out) v += by;
  return out;
}

// Pairs of neighbours: brought together in a random direction until they touch, then closer by
// `approach` [m]; if that is negative they stay apart.
[[nodiscard]] inline std::vector<Pair> random_pairs(const PolygonShape& shape, double approach) {
  Random random(1);
  std::vector<Pair> pairs;
  while (pairs.size() < cycle) {
    const ConvexPolygon a = random_polygon(shape, size, random);
    const ConvexPolygon b = random_polygon(shape, size, random);
    const Rotation at = Rotation::from_angle(random.uniform(0, 2 * std::numbers::pi));
    const Vec2 direction{at.cosine, at.sine};
    double inside = 0;
    double outside = 4 * size;
    while (outside - inside > 1e-6 * size) {
      const double middle = 0.5 * (inside + outside);
      SeparatingEdge cache;
      (separated(a.ring(), shifted(b.ring(), middle * direction), cache) ? outside : inside) =
          middle;
    }
    pairs.push_back(
        {shifted(a.ring(), {0, 0}), shifted(b.ring(), (outside - approach) * direction)});
  }
  return pairs;
}

// As in a run at some MPa: an overlap of a hundredth of the size.
[[nodiscard]] inline std::vector<Pair> touching_pairs(const PolygonShape& shape) {
  return random_pairs(shape, 0.01 * size);
}
// Near enough to be on the list of pairs, but apart.
[[nodiscard]] inline std::vector<Pair> near_pairs(const PolygonShape& shape) {
  return random_pairs(shape, -0.05 * size);
}

}  // namespace bench
