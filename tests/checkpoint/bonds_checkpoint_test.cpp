// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <riprap/bond/bond_law/brittle_bond.hpp>
#include <riprap/bond/bond_law/softening_bond.hpp>
#include <riprap/checkpoint/checkpoint.hpp>
#include <riprap/dynamics/boundary/periodic_cell.hpp>
#include <riprap/measurement/energy_ledger.hpp>
#include <riprap/particle/bond_common_edges.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/rectangle.hpp>
#include <support/temporary_file.hpp>

using namespace riprap;
using test::rectangle;

namespace {

/// Squares of 16 mm that fill a periodic cell, bonded, with a hole, each with a velocity.
Assembly filled_cell(double speed) {
  constexpr int rows = 5;
  const double side = 0.016;
  Assembly assembly{.thickness = 0.016, .particles = {}};
  assembly.period = {rows * side, rows * side};
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < rows; ++j)
      if (i != 2 || j != 2)
        assembly.particles.push_back({rectangle({side * i, side * j}, side, side),
                                      Motion::free,
                                      {speed * (i % 3 - 1), speed * (j % 2 - 0.5)}});
  bond_common_edges(assembly);
  return assembly;
}

template <class Sim>
std::uint64_t state_of(const Sim& sim, const EnergyLedger& ledger) {
  return digest(internal::checkpoint_fields(sim, ledger));
}

// 2 N steps = N steps, restart, N steps, before bonds break, while they do, and after.
template <class ModelType>
void check_restarts(const ModelType& model, bool breaks) {
  const auto start = [&](double speed) {
    Simulation<ModelType> sim{model, filled_cell(speed), Rock{}};
    sim.boundary().set_rate(-1, 0.5);
    return sim;
  };
  constexpr std::uint64_t last = 3000;
  auto whole = start(2);
  EnergyLedger ledger;
  ledger.open(whole);
  while (whole.steps() < last) whole.step(ledger);
  REQUIRE(whole.bond_breaks().size() > 3);
  REQUIRE(!whole.bonds().empty());
  CHECK(whole.breaks().empty() != breaks);
  const test::TemporaryFile file;
  const std::uint64_t broken = whole.bond_breaks()[2].step;
  for (const std::uint64_t stop : {std::uint64_t{5}, broken - 1, broken, last - 500}) {
    auto first = start(2);
    EnergyLedger of_first;
    of_first.open(first);
    while (first.steps() < stop) first.step(of_first);
    write_checkpoint(file.path(), first, of_first);
    auto second = start(1);  // nothing of it stays
    EnergyLedger of_second;
    read_checkpoint(file.path(), second, of_second);
    CHECK(state_of(second, of_second) == state_of(first, of_first));
    while (second.steps() < last) second.step(of_second);
    CHECK(state_of(second, of_second) == state_of(whole, ledger));
  }
}

}  // namespace

TEST_CASE("bonds that are held above their strength go on from a checkpoint, to the byte") {
  const auto start = [&] {
    Simulation sim{Model{}
                       .boundary(PeriodicCell{})
                       .criterion(NeverFails{})
                       .bond_law(SofteningBond{
                           .tensile_strength = 2e6, .shear_strength = 2e6, .fracture_energy = 50}),
                   filled_cell(2), Rock{}};
    sim.boundary().set_rate(-1, 0.5);
    sim.set_breakage(false);
    return sim;
  };
  EnergyLedger ledger;
  auto first = start();
  while (first.steps() < 1000) first.step();
  double largest = 0;  // traction of an undamaged bond [Pa]
  for (const auto& bond : first.bonds())
    for (const BondDisplacement& point : bond.view.points)
      largest = std::max(largest, 2.5e11 * std::max(point.opening, std::abs(point.sliding)));
  REQUIRE(largest > 2e6);
  const test::TemporaryFile file;
  write_checkpoint(file.path(), first, ledger);
  auto second = start();
  read_checkpoint(file.path(), second, ledger);
  CHECK(state_of(second, ledger) == state_of(first, ledger));
  for (const bool breakage : {false, true}) {
    first.set_breakage(breakage);
    second.set_breakage(breakage);
    for (int i = 0; i < 100; ++i) {
      first.step();
      second.step();
    }
    CHECK(state_of(second, ledger) == state_of(first, ledger));
  }
  CHECK(first.bonds().loss() > 0);
}

TEST_CASE("a run of a bonded sample goes on from a checkpoint, to the byte") {
  const auto model = Model{}.boundary(PeriodicCell{}).check_every(50);
  check_restarts(
      model.bond_law(BrittleBond{.tensile_strength = 2e6, .cohesion = 2e6}).criterion(NeverFails{}),
      false);
  check_restarts(model
                     .bond_law(SofteningBond{
                         .tensile_strength = 2e6, .shear_strength = 2e6, .fracture_energy = 50})
                     .criterion(HoekBrown{.compressive_strength = 3e6}),
                 true);
}
