// SPDX-License-Identifier: BSL-1.0
#include <cmath>

#include <riprap/bond/bond_law/concepts.hpp>
#include <riprap/particle/bond_common_edges.hpp>
#include <riprap/simulation/simulation.hpp>
using namespace riprap;

struct EnergyBond {  // elastic; breaks when an end of its edge stores the fracture energy
  double stiffness = 2e11, fracture_energy = 100;  // [Pa/m], [J/m^2]
  struct State {};                                 // nothing is kept from step to step
  BondTraction operator()(const BondDisplacement& d, State&) const {
    return {.normal = -stiffness * d.opening, .tangential = -stiffness * d.sliding};
  }
  double stored_energy(const BondDisplacement& d, const State&) const {
    return 0.5 * stiffness * (d.opening * d.opening + d.sliding * d.sliding);
  }
  BondFailure failure(const BondView<State>& bond) const {
    for (const BondDisplacement& end : bond.ends)
      if (end.opening > 0 && stored_energy(end, {}) >= fracture_energy) return BondFailure::tension;
    return BondFailure::none;
  }
  double peak_stiffness() const { return stiffness; }
};
static_assert(BondLaw<EnergyBond>);

int main() {
  const ConvexPolygon square{{0, 0}, {0.01, 0}, {0.01, 0.01}, {0, 0.01}};
  Assembly pulled{.particles = {{square, Motion::prescribed},
                                {square.moved({}, {0.01, 0}), Motion::prescribed, Vec2{0.1, 0}}}};
  bond_common_edges(pulled);
  Simulation sim{Model{}.bond_law(EnergyBond{}).criterion(NeverFails{}), pulled, Rock{}};
  while (sim.bond_breaks().empty() && sim.time() < 1e-2) sim.step();
  // The energy of the edge, 10 mm long and 16 mm thick, is gone.
  return std::abs(sim.bonds().loss() / (100 * 0.01 * 0.016) - 1) < 0.02 ? 0 : 1;
}
