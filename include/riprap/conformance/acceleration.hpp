// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The axiom of neighbour lists, detections, screenings and operator stores: no result depends on
/// them.

#include <algorithm>
#include <utility>
#include <vector>

#include <riprap/conformance/violations.hpp>
#include <riprap/core/random.hpp>
#include <riprap/dynamics/boundary/no_boundary.hpp>
#include <riprap/simulation/simulation.hpp>

namespace riprap {
namespace internal {

/// Sixteen pentagons of 16 mm that fly in all directions between two closing platens: contacts
/// begin and end, and some particles break.
[[nodiscard]] inline Assembly closing_platens() {
  const ConvexPolygon grain{
      {-0.008, -0.005}, {0.003, -0.008}, {0.008, -0.001}, {0.002, 0.008}, {-0.006, 0.006}};
  const ConvexPolygon slab{{-0.06, -0.01}, {0.06, -0.01}, {0.06, 0.01}, {-0.06, 0.01}};
  Random random(1);
  Assembly assembly{.thickness = 0.016, .particles = {}};
  for (int i = 0; i < 16; ++i) {
    const int column = i % 4;
    const int row = i / 4;
    const Vec2 centre{0.018 * (column - 1.5), 0.018 * (row - 1.5)};
    const Vec2 velocity{random.uniform(-4, 4), random.uniform(-4, 4)};
    const double turn = random.uniform(0, 6);
    assembly.particles.push_back({grain.moved(Rotation::from_angle(turn), centre), Motion::free,
                                  velocity, random.uniform(-300, 300)});
  }
  for (const double side : {1.0, -1.0})
    assembly.particles.push_back(
        {slab.moved({}, {0, 0.047 * side}), Motion::prescribed, Vec2{0, -4 * side}});
  return assembly;
}

}  // namespace internal

/// Which results of a simulation change, in whatever digit, when the model's neighbour list,
/// detection, screening and operator store are replaced by those that do nothing.
template <class ModelType>
[[nodiscard]] Violations acceleration_violations(const ModelType& model, int steps = 1200) {
  const auto accelerated = model.boundary(NoBoundary{});
  Simulation sim{accelerated, internal::closing_platens(), Rock{}};
  Simulation plain{accelerated.without_acceleration(), internal::closing_platens(), Rock{}};
  AxiomCheck check;
  for (int step = 1; step <= steps; ++step) {
    sim.step();
    plain.step();
    check.at("step", step);
    check.equal("as many particles break", static_cast<double>(sim.particles().size()),
                static_cast<double>(plain.particles().size()), 0);
    for (BodyIndex i = 0; i < std::min(sim.particles().size(), plain.particles().size()); ++i) {
      const Body& body = sim.particles().body(i);
      const Body& same = plain.particles().body(i);
      check.equal("poses are the same: distance", (body.position - same.position).norm(), 0, 0);
      check.equal("spins are the same", body.angular_velocity, same.angular_velocity, 0);
      check.equal("contact forces are the same: difference",
                  (body.contact.force - same.contact.force).norm(), 0, 0);
      check.equal("contact moments are the same", body.contact.moment, same.contact.moment, 0);
    }
  }
  return std::move(check).violations();
}

}  // namespace riprap
