// SPDX-License-Identifier: BSL-1.0
#pragma once
// Samples of any size that are as dense everywhere as a small one: a periodic cell, repeated.

#include <vector>

#include <riprap/dynamics/boundary/periodic_cell.hpp>
#include <riprap/experiment/biaxial_test.hpp>
#include <riprap/particle/random_box_assembly.hpp>
#include <riprap/simulation/simulation.hpp>

#include "support.hpp"

namespace bench {

// A periodic cell of 500 particles in early shear, with about four contacts each.
struct DenseCell {
  Assembly assembly;
  double rate = 0;  // of the shear [1/s]
};

[[nodiscard]] inline DenseCell dense_cell(const PolygonShape& shape, double pressure) {
  RandomAssembly options{.count = 500, .mean_diameter = size};
  options.shape = shape;
  Simulation sim{Model{}.boundary(PeriodicCell{}).criterion(NeverFails{}),
                 random_periodic_assembly(options), Rock{}};
  // Barely relaxed: what comes next is what counts.
  const BiaxialTest test{
      .confining_pressure = pressure, .axial_strain = 0.005, .rest_unbalanced_force = 0.1};
  DenseCell cell;
  cell.rate = test.run(sim).axial_rate;
  const Particles& particles = sim.particles();
  cell.assembly.thickness = particles.thickness();
  cell.assembly.period = sim.boundary().domain().period;
  for (BodyIndex i = 0; i < particles.size(); ++i) {
    const Ring ring = particles.ring(i);
    cell.assembly.particles.push_back({ConvexPolygon({ring.begin(), ring.end()})});
  }
  return cell;
}

// The cell so many times along either axis, with the velocities of a shear that keeps the volume.
// Contacts begin anew.
[[nodiscard]] inline Assembly tiled(const DenseCell& cell, unsigned columns, unsigned rows) {
  const Vec2 period = cell.assembly.period;
  Assembly sample{.thickness = cell.assembly.thickness,
                  .particles = {},
                  .period = {columns * period.x(), rows * period.y()}};
  for (unsigned i = 0; i < columns; ++i)
    for (unsigned j = 0; j < rows; ++j)
      for (const PlacedParticle& p : cell.assembly.particles) {
        const Vec2 offset{(i - 0.5 * (columns - 1)) * period.x(),
                          (j - 0.5 * (rows - 1)) * period.y()};
        const ConvexPolygon polygon = p.polygon.moved({}, offset);
        const Vec2 centre = area_properties(polygon.ring()).centroid;
        sample.particles.push_back(
            {polygon, Motion::free, cell.rate * Vec2{centre.x(), -centre.y()}});
      }
  return sample;
}

// In shear at constant volume, its contacts settled.
template <class ModelType>
[[nodiscard]] auto sheared(ModelType model, const DenseCell& cell, unsigned columns,
                           unsigned rows) {
  Simulation sim{model.boundary(PeriodicCell{}), tiled(cell, columns, rows), Rock{}};
  sim.boundary().set_rate(-cell.rate, cell.rate);
  for (int i = 0; i < 200; ++i) sim.step();
  return sim;
}

}  // namespace bench
