// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The axiom of a whole model: its simulation does not depend on the units.

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <riprap/conformance/units.hpp>
#include <riprap/conformance/violations.hpp>
#include <riprap/simulation/simulation.hpp>

namespace riprap {
namespace internal {

/// A particle of 16 mm with no symmetry, flying and turning between two platens half a millimetre
/// into it: it bears thousands of newtons, breaks where it can, and its pieces are thrown about.
[[nodiscard]] inline Assembly pressed_particle(const Units& units) {
  const auto polygon = [&units](std::vector<Vec2> vertices) {
    for (Vec2& v : vertices) v *= units.length;
    return ConvexPolygon(std::move(vertices));
  };
  const ConvexPolygon flying = polygon(
      {{-0.008, -0.005}, {0.003, -0.008}, {0.008, -0.001}, {0.002, 0.008}, {-0.006, 0.006}});
  const ConvexPolygon upper =
      polygon({{-0.02, 0.0075}, {0.02, 0.007}, {0.02, 0.02}, {-0.02, 0.02}});
  const ConvexPolygon lower =
      polygon({{-0.02, -0.02}, {0.02, -0.02}, {0.02, -0.0072}, {-0.02, -0.0076}});
  return {.thickness = 0.016 * units.length,
          .particles = {{flying, Motion::free, units.velocity() * Vec2{0.1, -0.05}, 2 / units.time},
                        {upper, Motion::prescribed},
                        {lower, Motion::prescribed}}};
}

}  // namespace internal

/// Which results of a simulation change, beyond their unit, when particles, rock and model are
/// given in other units.
/// @param other `model` with all its parameters in `units`
template <class ModelType>
[[nodiscard]] Violations simulation_unit_violations(const ModelType& model, const ModelType& other,
                                                    const Units& units = {}) {
  const Rock rock;
  Simulation sim{model, internal::pressed_particle({1, 1, 1}), rock};
  Simulation twin{other, internal::pressed_particle(units),
                  Rock{.young = rock.young * units.stress(),
                       .poisson = rock.poisson,
                       .density = rock.density * units.mass / (units.area() * units.length)}};
  AxiomCheck check;
  for (int step = 1; step <= 30; ++step) {
    sim.step();
    twin.step();
    check.at("step", step);
    check.equal("time is the same in other units", twin.time() / units.time, sim.time(),
                1e-12 * sim.time());
    check.equal("as many particles break in other units",
                static_cast<double>(twin.particles().size()),
                static_cast<double>(sim.particles().size()), 0);
    for (BodyIndex i = 0; i < std::min(sim.particles().size(), twin.particles().size()); ++i) {
      const Body& body = sim.particles().body(i);
      const Body& same = twin.particles().body(i);
      // Round-off of the first step, 1e-16, grows at every collision.
      check.equal("bodies go the same way in other units: distance",
                  (same.position / units.length - body.position).norm(), 0, 1e-9 * 0.016);
      check.equal("bodies are as fast in other units: difference",
                  (same.velocity / units.velocity() - body.velocity).norm(), 0,
                  1e-9 * (1 + body.velocity.norm()));
      check.equal("bodies spin as fast in other units", same.angular_velocity * units.time,
                  body.angular_velocity, 1e-9 * (100 + std::abs(body.angular_velocity)));
    }
  }
  return std::move(check).violations();
}

}  // namespace riprap
