// SPDX-License-Identifier: BSL-1.0
// Steps of a block of bonded squares, beside those of the same block without bonds.

#include <benchmark/benchmark.h>

#include <cmath>

#include <riprap/bond/bond_law/brittle_bond.hpp>
#include <riprap/bond/bond_law/softening_bond.hpp>
#include <riprap/dynamics/boundary/no_boundary.hpp>
#include <riprap/particle/bond_common_edges.hpp>
#include <riprap/simulation/simulation.hpp>

#include "support.hpp"

namespace bench {
namespace {

// Squares of 16 mm in rows, with velocities that strain the bonds and do not break them.
[[nodiscard]] Assembly block(int cells) {
  const int rows = static_cast<int>(std::lround(std::sqrt(cells)));
  const ConvexPolygon square{{0, 0}, {size, 0}, {size, size}, {0, size}};
  Assembly assembly{.thickness = size, .particles = {}};
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < rows; ++j)
      assembly.particles.push_back({square.moved({}, {size * i, size * j}),
                                    Motion::free,
                                    {0.01 * std::sin(i), 0.01 * std::cos(j)}});
  return assembly;
}

template <class ModelType>
void step_block(benchmark::State& state, const ModelType& model, bool bonded) {
  Assembly assembly = block(static_cast<int>(state.range(0)));
  if (bonded) bond_common_edges(assembly);
  Simulation sim{model.boundary(NoBoundary{}).criterion(NeverFails{}), assembly, Rock{}};
  for (auto _ : state) sim.step();
  count_time(state, "particle-step", static_cast<double>(sim.particles().size()));
}

void brittle(benchmark::State& state) { step_block(state, Model{}.bond_law(BrittleBond{}), true); }
BENCHMARK(brittle)->Name("bond/brittle")->Arg(400)->Arg(10000);

void softening(benchmark::State& state) {
  step_block(state, Model{}.bond_law(SofteningBond{}), true);
}
BENCHMARK(softening)->Name("bond/softening")->Arg(400)->Arg(10000);

void none(benchmark::State& state) { step_block(state, Model{}, false); }
BENCHMARK(none)->Name("bond/none")->Arg(400)->Arg(10000);

}  // namespace
}  // namespace bench
