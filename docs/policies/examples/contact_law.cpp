// SPDX-License-Identifier: BSL-1.0
#include <cmath>

#include <riprap/contact/contact_law/coulomb_slip.hpp>
#include <riprap/contact/contact_law/linear_spring_coulomb.hpp>
#include <riprap/dynamics/damping/no_damping.hpp>
#include <riprap/simulation/simulation.hpp>
using namespace riprap;

struct HertzianSpring {  // normal force stiffness * depth^1.5, tangential spring with Coulomb slip
  double stiffness = 1e9, tangential_stiffness = 1e7, friction = 0.5;  // [N/m^1.5], [N/m], [-]
  double deepest = 1e-4;                         // depth for which the time step is chosen [m]
  using History = LinearSpringCoulomb::History;  // what a contact carries: its tangential force
  ContactForce operator()(const ContactGeometry& at, const ContactMotion& m, History& h) const {
    ContactForce force{.normal = stiffness * std::pow(at.depth, 1.5) * at.depth_gradient};
    add_coulomb_slip(force, h.tangential_force, tangential_stiffness, friction, m);
    return force;
  }
  double stored_energy(const ContactGeometry& at, const History& h) const {
    return 0.4 * stiffness * std::pow(at.depth, 2.5) +
           tangential_energy(h.tangential_force, tangential_stiffness);
  }
  double peak_stiffness() const { return 1.5 * stiffness * std::sqrt(deepest); }
};

int main() {
  const ConvexPolygon square{{0, 0}, {0.016, 0}, {0.016, 0.016}, {0, 0.016}};
  const ConvexPolygon wall{{0.01601, -0.01}, {0.03, -0.01}, {0.03, 0.026}, {0.01601, 0.026}};
  const Assembly thrown{
      .particles = {{square, Motion::free, Vec2{0.2, 0}}, {wall, Motion::prescribed}}};
  Simulation sim{Model{}.contact_law(HertzianSpring{}).damping(NoDamping{}).criterion(NeverFails{}),
                 thrown, Rock{}};
  for (int i = 0; i < 400; ++i) sim.step();
  const double speed = sim.particles().body(0).velocity.x();
  return std::abs(speed + 0.2) < 0.002 ? 0 : 1;  // bounces back with the speed it came with
}
