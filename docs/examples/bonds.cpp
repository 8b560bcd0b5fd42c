// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <cstdio>
#include <vector>

#include <riprap/bond/bond_law/brittle_bond.hpp>
#include <riprap/dynamics/boundary/no_boundary.hpp>
#include <riprap/measurement/energy_ledger.hpp>
#include <riprap/measurement/fragments.hpp>
#include <riprap/particle/bond_common_edges.hpp>
#include <riprap/simulation/simulation.hpp>
using namespace riprap;

struct BreakCounter {  // of bonds that break, and of stones that fall apart
  int bonds = 0, separations = 0;
  void on_bond_break(const auto& /*sim*/, const BondBreak& event) {
    ++bonds;
    if (event.separates) ++separations;
  }
};

// A concave stone, an L of three bonded squares, falls on its knee.
int main() {
  const ConvexPolygon square{{0, 0}, {0.01, 0}, {0.01, 0.01}, {0, 0.01}};
  const ConvexPolygon floor{{-0.1, -0.02}, {0.1, -0.02}, {0.1, 0}, {-0.1, 0}};
  Assembly scene{.particles = {{floor, Motion::prescribed}}};
  std::vector<std::size_t> cells;
  for (const Vec2& at : {Vec2{0, 0}, Vec2{0.01, 0}, Vec2{0, 0.01}}) {
    cells.push_back(scene.particles.size());
    const Rotation tilt = Rotation::from_angle(0.2);
    scene.particles.push_back(
        {square.moved(tilt, Vec2{0, 1e-4} + tilt * at), Motion::free, {0, -3}});
  }
  bond_common_edges(scene, cells);
  const BrittleBond law{.tensile_strength = 1e6, .cohesion = 2e6};
  Simulation sim{Model{}.bond_law(law).boundary(NoBoundary{}).criterion(NeverFails{}), scene,
                 Rock{}};

  EnergyLedger ledger;
  ledger.open(sim);
  BreakCounter counter;
  while (sim.time() < 2e-3) sim.step(ledger, counter);
  const EnergyTerms energy = ledger.terms(sim);
  std::printf("%d bonds broken, %d separations, %.2g J lost in bonds\n", counter.bonds,
              counter.separations, energy.bonds);
  for (const Fragment& fragment : fragments(sim))
    std::printf("fragment %u of stone %u: %zu cells, %.3g m^2\n", fragment.number, fragment.root,
                fragment.bodies.size(), fragment.area);
  const std::size_t stones = fragments(sim).size() - 1;  // beside the floor
  const bool counted = stones == 1 + static_cast<std::size_t>(counter.separations);
  return counted && counter.bonds > 0 && energy.bonds > 0 ? 0 : 1;
}
