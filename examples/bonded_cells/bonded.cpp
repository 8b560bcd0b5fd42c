// SPDX-License-Identifier: BSL-1.0
#include "bonded.hpp"

#include <algorithm>
#include <numbers>
#include <utility>
#include <vector>

#include <riprap/breakage/criterion/never_fails.hpp>
#include <riprap/dynamics/boundary/no_boundary.hpp>
#include <riprap/geometry/voronoi_cells.hpp>
#include <riprap/particle/bond_common_edges.hpp>
#include <riprap/simulation/simulation.hpp>

namespace bonded_cells {

using namespace riprap;

namespace {

// Largest force between two plates before it falls by a tenth [N].
double peak_force(const BondedDisc& d, const BrittleBond& bond, std::uint64_t seed) {
  constexpr unsigned sides = 24;
  const double r = 0.5 * d.diameter;
  std::vector<Vec2> corners;
  for (unsigned k = 0; k < sides; ++k)
    corners.push_back(Rotation::from_angle(2 * std::numbers::pi * k / sides) * Vec2{0, r});
  Assembly assembly = bonded(
      {.thickness = d.thickness, .particles = {{.polygon = ConvexPolygon(std::move(corners))}}},
      d.cells, seed);
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

Assembly bonded(const Assembly& sample, unsigned cells, std::uint64_t seed) {
  Assembly out = sample;
  out.particles.clear();
  for (std::size_t k = 0; k < sample.particles.size(); ++k) {
    const PlacedParticle& particle = sample.particles[k];
    if (particle.motion != Motion::free) {
      out.particles.push_back(particle);
      continue;
    }
    std::vector<std::size_t> places;
    for (const ConvexPolygon& cell :
         voronoi_cells(particle.polygon, {.count = cells, .seed = seed + k})) {
      places.push_back(out.particles.size());
      out.particles.push_back(particle);
      out.particles.back().polygon = cell;
    }
    bond_common_edges(out, places);
  }
  return out;
}

double brazilian_strength(const BondedDisc& disc, const BrittleBond& bond) {
  double sum = 0;
  for (unsigned k = 0; k < disc.discs; ++k) sum += peak_force(disc, bond, k + 1);
  return 2 * sum / disc.discs / (std::numbers::pi * disc.diameter * disc.thickness);
}

BrittleBond calibrated_bond(const BondedDisc& disc, double strength) {
  BrittleBond bond{.normal_stiffness = 4e12, .tangential_stiffness = 4e12};
  for (int k = 0; k < 4; ++k) {
    const double factor = strength / brazilian_strength(disc, bond);
    bond.tensile_strength *= factor;
    bond.cohesion *= factor;
  }
  return bond;
}

}  // namespace bonded_cells
