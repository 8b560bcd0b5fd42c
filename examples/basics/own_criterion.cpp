// SPDX-License-Identifier: BSL-1.0
// own_criterion: a failure criterion of one's own; twice the strength takes twice the force
// A criterion is two functions: sigma_1 at failure for a given sigma_3, and the tensile strength.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <riprap/riprap.hpp>
using namespace riprap;

struct Tresca {            // fails where sigma_1 - sigma_3 reaches the strength
  double strength = 40e6;  // in compression [Pa]
  double tension = 10e6;   // [Pa], positive
  double major_stress_at_failure(double minor) const { return minor + strength; }
  double tensile_strength() const { return tension; }
  void validate() const {  // optional: refuses values that have no meaning
    require_positive("Tresca.strength", strength);
    require_positive("Tresca.tension", tension);
  }
};

struct ForceAtBreak {  // an observer: contacts as they are just before a particle breaks
  double force = 0;    // largest normal force [N]
  void before_splits(const auto& sim) {
    sim.contacts().for_each_touching(
        [&](const auto& contact) { force = std::max(force, contact.force.normal); });
  }
};

/// Force [N] at which a square between two approaching platens breaks, and its step per time step.
struct Crushing {
  double force = 0;
  double resolution = 0;
};

Crushing crush(const Tresca& criterion) {
  const ConvexPolygon square{{0, 0}, {0.016, 0}, {0.016, 0.016}, {0, 0.016}};
  const ConvexPolygon platen{{-0.02, 0}, {0.04, 0}, {0.04, 0.016}, {-0.02, 0.016}};
  const Vec2 speed{0, 0.1};  // [m/s]
  const EnergyConservingSpring springs;
  const Assembly assembly{
      .particles = {{square},
                    {platen.moved({}, {0, 0.016}), Motion::prescribed, -speed},
                    {platen.moved({}, {0, -0.016}), Motion::prescribed, speed}}};
  Simulation sim{Model{}.contact_law(springs).criterion(criterion), assembly, Rock{}};
  ForceAtBreak at_break;
  while (sim.breaks().empty()) sim.step(at_break);
  return {at_break.force, springs.peak_stiffness() * speed.y() * sim.time_step()};
}

int main() {
  const Crushing weak = crush({.strength = 40.0_MPa, .tension = 10.0_MPa});
  const Crushing strong = crush({.strength = 80.0_MPa, .tension = 20.0_MPa});
  std::printf("force at breakage: %.0f N, and %.0f N with twice the strength\n", weak.force,
              strong.force);
  std::printf("ratio %.4f, closed form 2 (stress is linear in the load)\n",
              strong.force / weak.force);
  // Each force is the first of a step at or above the one that breaks the particle.
  return std::abs(strong.force - 2 * weak.force) <= 2 * weak.resolution ? 0 : 1;
}
