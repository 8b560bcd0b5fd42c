// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Do two models run the same, to the last bit?

#include <array>
#include <cstring>
#include <vector>

#include <riprap/dynamics/boundary/no_boundary.hpp>
#include <riprap/particle/assembly.hpp>
#include <riprap/simulation/simulation.hpp>

namespace riprap::test {

/// Blocks that fall on a floor that moves, strike each other, slide, spin and, under the upper
/// platen, break. Poses, velocities, forces and all energy booked, step by step.
/// @param materials of the two blocks and the two slabs, places in `rocks`
template <class ModelType>
[[nodiscard]] std::vector<double> run_of(const ModelType& model, int steps,
                                         const Rocks& rocks = Rock{},
                                         const std::array<MaterialIndex, 4>& materials = {}) {
  const ConvexPolygon block{{-0.008, -0.008}, {0.008, -0.007}, {0.007, 0.008}, {-0.008, 0.006}};
  const ConvexPolygon slab{{-0.04, -0.01}, {0.04, -0.01}, {0.04, 0}, {-0.04, 0}};
  const Rotation tilt = Rotation::from_angle(0.3);
  Assembly assembly{.particles = {{block.moved({}, {0.014, 0.008}), Motion::free, {0, 0}},
                                  {block.moved(tilt, {-0.008, 0.0105}), Motion::free, {3, -1}},
                                  {slab, Motion::prescribed, {0.5, 0}},
                                  {slab.moved({}, {0.04, 0.0259}), Motion::prescribed, {0, -0.5}}}};
  for (std::size_t i = 0; i < materials.size(); ++i) assembly.particles[i].material = materials[i];
  Simulation sim{model.boundary(NoBoundary{}), assembly, rocks};
  sim.set_body_force({0, -9.81});
  std::vector<double> numbers;
  for (int i = 0; i < steps; ++i) {
    sim.step();
    for (const Body& b : sim.particles().bodies())
      for (const double x :
           {b.position.x(), b.position.y(), b.rotation.sine, b.velocity.x(), b.velocity.y(),
            b.angular_velocity, b.contact.force.x(), b.contact.force.y(), b.contact.moment})
        numbers.push_back(x);
    for (const double x : {sim.work().boundary, sim.work().body_force, sim.work().damping,
                           sim.contacts().friction_loss(), sim.contacts().viscous_loss()})
      numbers.push_back(x);
  }
  return numbers;
}

[[nodiscard]] inline bool same_bytes(const std::vector<double>& p, const std::vector<double>& q) {
  return p.size() == q.size() && std::memcmp(p.data(), q.data(), p.size() * sizeof(double)) == 0;
}

}  // namespace riprap::test
