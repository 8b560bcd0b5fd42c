// SPDX-License-Identifier: BSL-1.0
// two_particles: a corner strikes a block; the impact force beside v sqrt(k m), then a crack
// Two free particles without gravity, at a speed at which neither breaks and at a higher one.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <riprap/output/assembly_picture.hpp>
#include <riprap/riprap.hpp>
using namespace riprap;

struct Impact {         // an observer
  double largest = 0;   // normal force so far [N]
  double at_break = 0;  // the same when the first particle breaks [N]
  void after_forces(const auto& sim) {
    sim.contacts().for_each_touching(
        [&](const auto& contact) { largest = std::max(largest, contact.force.normal); });
  }
  void before_splits(const auto& /*sim*/) {
    if (at_break == 0) at_break = largest;
  }
};

/// A block at rest and a corner that meets the middle of its left side with a speed [m/s].
auto collision(double speed) {
  const ConvexPolygon block{{0, -0.008}, {0.016, -0.008}, {0.016, 0.008}, {0, 0.008}};
  const ConvexPolygon corner{{-0.012, -0.012}, {-0.00001, 0}, {-0.012, 0.012}};
  const Assembly assembly{.particles = {{block}, {corner, Motion::free, Vec2{speed, 0}}}};
  const HoekBrown soft_rock{.compressive_strength = 50.0_MPa};
  return Simulation{Model{}.criterion(soft_rock).damping(NoDamping{}), assembly, Rock{}};
}

int main() {
  const double speed = 0.2;  // [m/s]
  auto slow = collision(speed);
  Impact slow_impact;
  while (slow.time() < 1e-3) slow.step(slow_impact);
  const double m0 = slow.particles().body(0).mass;
  const double m1 = slow.particles().body(1).mass;
  const double effective = m0 * m1 / (m0 + m1);  // of two free bodies [kg]
  const double expected = speed * std::sqrt(EnergyConservingSpring{}.normal_stiffness * effective);
  std::printf("at %4.1f m/s: largest force %.2f N, closed form %.2f N, %zu breakages\n", speed,
              slow_impact.largest, expected, slow.breaks().size());

  Impact impact;
  auto fast = collision(50 * speed);
  while (fast.breaks().empty() && fast.time() < 1e-3) fast.step(impact);
  std::printf("at %4.1f m/s: a particle breaks at %.0f N, of %.0f N without breakage\n", 50 * speed,
              impact.at_break, 50 * expected);
  if (fast.breaks().empty()) return 1;
  const BreakEvent& event = fast.breaks()[0];
  std::printf("particle %u, in %s first, Rat %.2f; pieces of %.1f and %.1f mm^2\n",
              event.particle.id, to_text(event.mode), event.failures.ratio(), 1e6 * event.areas[0],
              1e6 * event.areas[1]);
  while (fast.time() < 1e-3) fast.step();
  assembly_picture(fast.particles(), {}, "A corner has struck a block").save("two_particles.svg");
  std::printf("picture in two_particles.svg\n");
  // The spring's half period is some 25 steps, and the integrator is of first order in the step.
  const bool close = std::abs(slow_impact.largest / expected - 1) <= 1.0 / 25;
  return close && slow.breaks().empty() && impact.at_break < 50 * expected ? 0 : 1;
}
