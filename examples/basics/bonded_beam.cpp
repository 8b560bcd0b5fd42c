// SPDX-License-Identifier: BSL-1.0
// bonded_beam: a cantilever of bonded squares; deflection and strength beside closed forms
// The first square is held; the load at the last one grows slowly until a bond breaks.

#include <cmath>
#include <cstdio>

#include <riprap/measurement/fragments.hpp>
#include <riprap/output/bond_picture.hpp>
#include <riprap/riprap.hpp>
using namespace riprap;

constexpr int cells = 6;             // that are free
constexpr double side = 10.0_mm;     // of a square
constexpr double thickness = 16_mm;  // out of the plane

/// A row of squares, bonded along their common edges.
Assembly row() {
  const ConvexPolygon square{{0, 0}, {side, 0}, {side, side}, {0, side}};
  Assembly assembly{.thickness = thickness, .particles = {}};
  for (int i = 0; i <= cells; ++i)
    assembly.particles.push_back(
        {square.moved({}, {side * i, 0}), i == 0 ? Motion::prescribed : Motion::free});
  bond_common_edges(assembly);
  return assembly;
}

int main() {
  const BrittleBond law{.tensile_strength = 5_MPa, .cohesion = 20_MPa};
  Simulation sim{Model{}.boundary(NoBoundary{}).criterion(NeverFails{}).bond_law(law), row(),
                 Rock{}};
  const auto tip = static_cast<BodyIndex>(cells);
  const double start = sim.particles().body(tip).position.y();

  // Joint j, from 0 on, has the moment P h (n - j - 1/2) of the load P at the centroid of square n.
  // It turns by M / (k_n t h^3 / 12) and slides by P / (k_s h t).
  double levers = 0;
  for (int m = 0; m < cells; ++m) levers += (m + 0.5) * (m + 0.5);
  const double per_force = 12 * levers / (law.normal_stiffness * thickness * side) +
                           cells / (law.tangential_stiffness * side * thickness);
  // At the strength of the first joint's extreme fibre, 6 M / (t h^2).
  const double strength =
      law.tensile_strength * thickness * side / (6 * (static_cast<double>(cells) - 0.5));

  double load = 0;        // [N]
  double deflection = 0;  // at half of the strength [m]
  const double step = strength / 200'000;
  while (sim.bond_breaks().empty() && load < 2 * strength) {
    sim.set_load(tip, {0, -load});
    sim.step();
    if (load < 0.5 * strength) deflection = start - sim.particles().body(tip).position.y();
    load += step;
  }
  const double expected = 0.5 * strength * per_force;
  std::printf("deflection at half of the strength: %.4g mm, of the chain of joints %.4g mm\n",
              1e3 * deflection, 1e3 * expected);
  std::printf("load when the first bond breaks: %.4g N, at its extreme fibre %.4g N\n", load,
              strength);
  const bool at_support = sim.bond_breaks().size() == 1 && sim.bond_breaks()[0].particles[0] == 0;
  std::printf("%zu fragments; the bond at the support broke: %s\n", fragments(sim).size(),
              at_support ? "yes" : "no");
  bond_picture(sim, "A cantilever that has broken").save("bonded_beam.svg");
  const bool close =
      std::abs(deflection / expected - 1) < 0.01 && std::abs(load / strength - 1) < 0.01;
  return close && at_support ? 0 : 1;
}
