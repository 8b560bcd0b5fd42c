// SPDX-License-Identifier: BSL-1.0
// own_contact_law: a contact law of one's own with a history; restitution beside sqrt(k1 / k2)
// A law gives the force of a contact from its geometry, its motion and its history.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <riprap/riprap.hpp>
using namespace riprap;

/// Plastic contact of Walton and Braun (1986): loading along k1, unloading along the steeper k2.
/// Without friction.
struct PlasticSpring {
  double loading = 2e6;    // k1 [N/m]
  double unloading = 8e6;  // k2 [N/m], above k1

  struct History {       // what a contact carries from step to step
    double deepest = 0;  // [m]
  };

  ContactForce operator()(const ContactGeometry& at, const ContactMotion& motion,
                          History& history) const {
    const double before = history.deepest;
    history.deepest = std::max(before, at.depth);
    ContactForce force{.normal = normal_force(at.depth, history) * at.depth_gradient};
    if (motion.time_step > 0)  // what loading leaves behind in the contact [J]
      force.viscous_loss = 0.5 * loading * (1 - loading / unloading) *
                           (history.deepest * history.deepest - before * before);
    return force;
  }
  double stored_energy(const ContactGeometry& at, const History& history) const {
    const double force = normal_force(at.depth, history);
    return 0.5 * force * force / unloading;
  }
  double peak_stiffness() const { return unloading; }  // sets the time step

 private:
  double normal_force(double depth, const History& history) const {
    return std::max(0.0, loading * history.deepest - unloading * (history.deepest - depth));
  }
};

int main() {
  const double speed = 0.2;  // [m/s]
  const PlasticSpring law;
  const ConvexPolygon square{{0, 0}, {0.016, 0}, {0.016, 0.016}, {0, 0.016}};
  const ConvexPolygon wall{{0.01601, -0.01}, {0.03, -0.01}, {0.03, 0.026}, {0.01601, 0.026}};
  const Assembly thrown{
      .particles = {{square, Motion::free, Vec2{speed, 0}}, {wall, Motion::prescribed}}};
  Simulation sim{Model{}.contact_law(law).damping(NoDamping{}).criterion(NeverFails{}), thrown,
                 Rock{}};
  const auto& block = sim.particles().body(0);
  const double before = block.kinetic_energy();
  while (block.contact.force.x() == 0) sim.step();
  while (block.contact.force.x() != 0) sim.step();

  const double restitution = -block.velocity.x() / speed;
  const double expected = std::sqrt(law.loading / law.unloading);
  const double loss = before - block.kinetic_energy();
  std::printf("coefficient of restitution %.5f, closed form %.5f\n", restitution, expected);
  std::printf("kinetic energy lost %.5e J, booked by the law %.5e J\n", loss,
              sim.contacts().viscous_loss());
  // The collision takes some 40 steps, and the integrator is of first order in the step.
  const double tolerance = 1.0 / 40;
  return std::abs(restitution / expected - 1) <= tolerance &&
                 std::abs(sim.contacts().viscous_loss() / loss - 1) <= tolerance
             ? 0
             : 1;
}
