// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <optional>

#include <riprap/simulation/simulation.hpp>
using namespace riprap;

const ContactLoad& largest_load(const LoadedParticle& particle) {
  const auto less = [](const ContactLoad& a, const ContactLoad& b) {
    return a.normal_force < b.normal_force;
  };
  return *std::max_element(particle.loads().begin(), particle.loads().end(), less);
}
struct PointLoadStrength {  // largest normal force over width and thickness
  double strength = 5e6;    // [Pa]
  FailureMode operator()(const LoadedParticle& particle) const {
    if (particle.loads().empty()) return FailureMode::intact;
    const double force = largest_load(particle).normal_force;
    const double section = equivalent_diameter(particle.area()) * particle.thickness();
    return force >= strength * section ? FailureMode::tension : FailureMode::intact;
  }
};
struct AlongLargestForce {  // through the centroid
  std::optional<Line> operator()(const LoadedParticle& particle) const {
    return Line{particle.centroid(), largest_load(particle).force_lab.normalized()};
  }
};

int main() {
  const ConvexPolygon square{{0, 0}, {0.016, 0}, {0.016, 0.016}, {0, 0.016}};
  const ConvexPolygon platen{{-0.02, 0}, {0.04, 0}, {0.04, 0.016}, {-0.02, 0.016}};
  const Assembly pressed{.particles = {{square},  // 1 mm deep in a platen on either side
                                       {platen.moved({}, {0, 0.0150}), Motion::prescribed},
                                       {platen.moved({}, {0, -0.0150}), Motion::prescribed}}};
  Simulation sim{Model{}.trigger(PointLoadStrength{}).line_fit(AlongLargestForce{}), pressed,
                 Rock{}};
  static_assert(!decltype(sim)::needs_elements);
  for (int i = 0; i < 3; ++i) sim.step();
  return !sim.breaks().empty() && sim.breaks()[0].mode == FailureMode::tension ? 0 : 1;
}
