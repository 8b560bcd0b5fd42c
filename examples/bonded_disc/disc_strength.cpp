// SPDX-License-Identifier: BSL-1.0
#include "disc_strength.hpp"

#include <algorithm>
#include <numbers>
#include <utility>
#include <vector>

#include <riprap/breakage/criterion/never_fails.hpp>
#include <riprap/dynamics/boundary/no_boundary.hpp>
#include <riprap/particle/bonded_cells.hpp>
#include <riprap/simulation/simulation.hpp>

namespace bonded_disc {

using namespace riprap;

namespace {

// Largest force between two plates before it falls by a tenth [N].
double peak_force(const BondedDisc& d, const BrittleBond& bond, std::uint64_t seed) {
  constexpr unsigned sides = 24;
  const double r = 0.5 * d.diameter;
  std::vector<Vec2> corners;
  for (unsigned k = 0; k < sides; ++k)
    corners.push_back(Rotation::from_angle(2 * std::numbers::pi * k / sides) * Vec2{0, r});
  Assembly assembly = bonded_cells(
      {.thickness = d.thickness, .particles = {{.polygon = ConvexPolygon(std::move(corners))}}},
      {.count = d.cells, .seed = seed});
  const auto plate = [&](double side) {
    const double low = side > 0 ? r : -2 * r;
    return PlacedParticle{ConvexPolygon{{-r, low}, {r, low}, {r, low + r}, {-r, low + r}},
                          Motion::wall,
                          {0, -side * d.speed}};
  };
  const std::size_t upper = assembly.particles.size();
  assembly.particles.push_back(plate(1));
  assembly.particles.push_back(plate(-1));
  Simulation sim{Model{}.criterion(NeverFails{}).boundary(NoBoundary{}).bond_law(bond), assembly,
                 Rock{}};
  const double touch = 1e-3 * bond.tensile_strength * d.diameter * d.thickness;
  double peak = 0;
  double force = 0;
  while (peak < touch || force > 0.9 * peak) {
    if (sim.time() * d.speed > 0.1 * d.diameter)
      throw SimulationError("a disc of bonded cells has not failed at a strain of 0.2");
    sim.step();
    force = sim.force_on(static_cast<BodyIndex>(upper)).force.y();
    peak = std::max(peak, force);
  }
  return peak;
}

}  // namespace

double brazilian_strength(const BondedDisc& disc, const BrittleBond& bond) {
  double sum = 0;
  for (unsigned k = 0; k < disc.discs; ++k) sum += peak_force(disc, bond, k + 1);
  return 2 * sum / disc.discs / (std::numbers::pi * disc.diameter * disc.thickness);
}

BrittleBond calibrated_bond(const BondedDisc& disc, double strength) {
  BrittleBond bond{.normal_stiffness = disc.stiffness, .tangential_stiffness = disc.stiffness};
  for (int k = 0; k < 4; ++k) {
    const double factor = strength / brazilian_strength(disc, bond);
    bond.tensile_strength *= factor;
    bond.cohesion *= factor;
  }
  return bond;
}

}  // namespace bonded_disc
