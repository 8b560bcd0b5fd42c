// SPDX-License-Identifier: BSL-1.0
// From element stresses to two pieces. criterion/*: a criterion evaluated and tallied in the 100
// elements of one particle, about a tenth of them failed. line_fit and cut: one call an iteration,
// made only for particles that break, so they hardly matter in a run. Not measured: the mesh and
// the operator of the pieces (stress/build_operator), by far the larger part of the cost of a
// break.

#include <riprap/breakage/criterion/franklin.hpp>
#include <riprap/breakage/criterion/hobbs.hpp>
#include <riprap/breakage/criterion/hoek_brown.hpp>
#include <riprap/breakage/criterion/mohr_coulomb.hpp>
#include <riprap/breakage/criterion/murrell.hpp>
#include <riprap/breakage/failure/failure_count.hpp>
#include <riprap/breakage/line_fit/weighted_xy.hpp>
#include <riprap/breakage/splitter/straight_cut.hpp>

#include "support.hpp"

namespace bench {
namespace {

constexpr std::size_t elements = 100;

// Intact, failed in tension and failed in shear, without any order.
[[nodiscard]] std::vector<ElementStress> random_stresses() {
  Random random(1);
  std::vector<ElementStress> all(64);
  for (ElementStress& stress : all) {
    stress.reset(elements);
    for (std::size_t e = 0; e < elements; ++e)
      stress.set(e, {random.uniform(-20e6, 400e6), random.uniform(-20e6, 400e6),
                     random.uniform(-50e6, 50e6)});
  }
  return all;
}

template <class CriterionT>
void count(benchmark::State& state) {
  const std::vector<ElementStress> stresses = random_stresses();
  const CriterionT criterion;
  std::size_t i = 0;
  std::size_t failed = 0;
  for (auto _ : state) {
    FailureCount result = count_failures(criterion, stresses[i++ % stresses.size()]);
    benchmark::DoNotOptimize(result);
    failed += result.failed;
  }
  count_time(state, "element", elements);
  state.counters["failed"] = static_cast<double>(failed) / static_cast<double>(i * elements);
}

// A cloud of 40 failed elements, as many as it takes to break one of 100; two failure planes.
void weighted_xy(benchmark::State& state) {
  Random random(1);
  constexpr std::size_t points = 40;
  std::vector<WeightedPoint> all(64 * points);
  for (WeightedPoint& p : all)
    p = {size * Vec2{random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)}, random.uniform(1, 3)};
  const FailurePlanes planes = failure_planes(HoekBrown{}, {200e6, 30e6, 40e6}, FailureMode::shear);
  std::size_t i = 0;
  for (auto _ : state) {
    const std::size_t first = points * (i++ % 64);
    auto line = WeightedXY{}(std::span<const WeightedPoint>(all).subspan(first, points), planes);
    benchmark::DoNotOptimize(line);
  }
  count_time(state, "point", points);
}

// Lines near the centroid; what fails the sliver rule is cut first and refused after.
template <const PolygonShape& shape>
void straight_cut(benchmark::State& state) {
  Random random(1);
  std::vector<ConvexPolygon> polygons;
  std::vector<Line> lines;
  for (std::size_t k = 0; k < cycle; ++k) {
    polygons.push_back(random_polygon(shape, size, random));
    const Rotation along = Rotation::from_angle(random.uniform(0, 2 * std::numbers::pi));
    lines.push_back({size * Vec2{random.uniform(-0.15, 0.15), random.uniform(-0.15, 0.15)},
                     Vec2{along.cosine, along.sine}});
  }
  const double mean_area = 0.25 * std::numbers::pi * size * size;
  std::size_t i = 0;
  std::size_t refused = 0;
  for (auto _ : state) {
    auto pieces = StraightCut{}(polygons[i % cycle].ring(), lines[i % cycle], mean_area);
    benchmark::DoNotOptimize(pieces);
    refused += !pieces;
    ++i;
  }
  state.counters["refused"] = static_cast<double>(refused) / static_cast<double>(i);
}

BENCHMARK(count<HoekBrown>)->Name("criterion/hoek_brown");
BENCHMARK(count<MohrCoulomb>)->Name("criterion/mohr_coulomb");
BENCHMARK(count<Murrell>)->Name("criterion/murrell");
BENCHMARK(count<Hobbs>)->Name("criterion/hobbs");
BENCHMARK(count<Franklin>)->Name("criterion/franklin");
BENCHMARK(weighted_xy)->Name("line_fit/weighted_xy");
BENCHMARK(straight_cut<blunt>)->Name("cut/straight_cut");
BENCHMARK(straight_cut<sharp>)->Name("cut/straight_cut/sharp");

}  // namespace
}  // namespace bench
