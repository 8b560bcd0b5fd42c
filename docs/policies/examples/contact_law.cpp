#include <cmath>

#include <riprap/dynamics/damping/no_damping.hpp>
#include <riprap/simulation/simulation.hpp>
using namespace riprap;

struct HertzianSpring {    // normal force stiffness * depth^1.5, no friction
  double stiffness = 1e9;  // [N/m^1.5]
  double deepest = 1e-4;   // depth for which the time step is chosen [m]
  struct History {};       // a contact carries nothing from step to step
  ContactForce operator()(const ContactGeometry& at, const ContactMotion&, History&) const {
    return {.normal = stiffness * at.depth * std::sqrt(at.depth)};
  }
  double stored_energy(const ContactGeometry& at, const History&) const {
    return 0.4 * stiffness * at.depth * at.depth * std::sqrt(at.depth);
  }
  double peak_stiffness() const { return 1.5 * stiffness * std::sqrt(deepest); }
  void validate() const { require_positive("HertzianSpring.stiffness", stiffness); }
};

int main() {
  const ConvexPolygon square{{0, 0}, {0.016, 0}, {0.016, 0.016}, {0, 0.016}};
  const ConvexPolygon wall{{0.01601, -0.01}, {0.03, -0.01}, {0.03, 0.026}, {0.01601, 0.026}};
  const Assembly thrown{
      .particles = {{square, Motion::free, Vec2{0.2, 0}}, {wall, Motion::prescribed}}};
  Simulation sim{Model{}.contact(HertzianSpring{}).damping(NoDamping{}).criterion(NeverFails{}),
                 thrown, Rock{}};
  for (int i = 0; i < 400; ++i) sim.step();
  const double speed = sim.particles().body(0).velocity.x();
  return std::abs(speed + 0.2) < 0.002 ? 0 : 1;  // bounces back with the speed it came with
}
