// SPDX-License-Identifier: BSL-1.0
// Contacts: their geometry, their force, and the search for pairs. The first two cost one call an
// iteration, on pairs that touch (those that do not are in geometry/separated_*). The broad phase
// is one search among N boxes, as it is made when something has moved by half the skin; computing
// the boxes, sorting the pairs and carrying contacts over are not in it.

#include <cmath>
#include <cstdint>
#include <limits>

#include <riprap/contact/broad_phase/uniform_grid.hpp>
#include <riprap/contact/contact_law/linear_spring_coulomb.hpp>
#include <riprap/contact/narrow_phase/overlap_chord.hpp>
#include <riprap/contact/narrow_phase/overlap_moments.hpp>

#include "support.hpp"

namespace bench {
namespace {

template <const PolygonShape& shape, class Narrow>
void narrow_phase(benchmark::State& state) {
  const std::vector<Pair> pairs = touching_pairs(shape);
  const Narrow narrow;
  std::vector<typename Narrow::Cache> memories(cycle);
  std::size_t i = 0;
  for (auto _ : state) {
    const auto& [a, b] = pairs[i % cycle];
    auto contact = narrow(a, b, memories[i++ % cycle]);
    benchmark::DoNotOptimize(contact);
  }
}

// Motion to and fro, so that some contacts stick and some slip.
void linear_spring_coulomb(benchmark::State& state) {
  Random random(1);
  const LinearSpringCoulomb law;
  std::vector<ContactGeometry> contacts(cycle);
  for (ContactGeometry& c : contacts) c.depth = size * random.uniform(0, 0.02);
  std::vector<ContactMotion> motions(cycle - 3);  // no common divisor: other motion every round
  for (ContactMotion& m : motions)
    m = {.tangential_velocity = random.uniform(-20, 20), .time_step = 2e-6, .effective_mass = 1e-3};
  std::vector<LinearSpringCoulomb::History> histories(cycle);
  std::size_t i = 0;
  std::size_t k = 0;
  for (auto _ : state) {
    ContactForce force = law(contacts[i % cycle], motions[k], histories[i % cycle]);
    benchmark::DoNotOptimize(force);
    ++i;
    if (++k == motions.size()) k = 0;
  }
}

// Boxes of sharp particles, grown by the skin, packed as densely as in a jammed sample: at random
// places in the cells of a square lattice.
[[nodiscard]] std::vector<Box> packed_boxes(std::size_t count, double skin) {
  Random random(1);
  const double solid = 0.85;
  const double cell = size * std::sqrt(std::numbers::pi / (4 * solid));
  const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 at = cell * Vec2{static_cast<double>(i % columns) + random.uniform(-0.25, 0.25),
                                static_cast<double>(i / columns) + random.uniform(-0.25, 0.25)};
    Box box{Vec2::Constant(std::numeric_limits<double>::infinity()),
            Vec2::Constant(-std::numeric_limits<double>::infinity())};
    for (const Vec2& v : random_polygon(sharp, size * random.uniform(0.7, 1.3), random)) {
      box.low = box.low.cwiseMin(at + v);
      box.high = box.high.cwiseMax(at + v);
    }
    box.low.array() -= 0.5 * skin;
    box.high.array() += 0.5 * skin;
    boxes.push_back(box);
  }
  return boxes;
}

void broad_phase(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const UniformGrid broad;
  const std::vector<Box> boxes = packed_boxes(count, broad.relative_skin * size);
  std::vector<std::pair<BodyIndex, BodyIndex>> pairs;
  for (auto _ : state) {
    pairs.clear();
    broad.visit_pairs(boxes, [&](BodyIndex i, BodyIndex j) { pairs.emplace_back(i, j); });
    benchmark::DoNotOptimize(pairs.data());
  }
  count_time(state, "box", static_cast<double>(count));
  state.counters["pairs/box"] = static_cast<double>(pairs.size()) / static_cast<double>(count);
}

BENCHMARK(narrow_phase<blunt, OverlapChord>)->Name("contact/narrow_phase");
BENCHMARK(narrow_phase<sharp, OverlapChord>)->Name("contact/narrow_phase/sharp");
BENCHMARK(narrow_phase<blunt, OverlapMoments>)->Name("contact/narrow_phase/moments");
BENCHMARK(narrow_phase<sharp, OverlapMoments>)->Name("contact/narrow_phase/moments/sharp");
BENCHMARK(linear_spring_coulomb)->Name("contact/linear_spring_coulomb");
BENCHMARK(broad_phase)->Name("contact/broad_phase")->Arg(500)->Arg(5000)->Arg(50000);

}  // namespace
}  // namespace bench
