// SPDX-License-Identifier: BSL-1.0
#include <cmath>

#include <riprap/contact/contact_law/linear_spring_coulomb.hpp>
#include <riprap/contact/mixing_rule/mixed_contact_law.hpp>
#include <riprap/core/units.hpp>
#include <riprap/dynamics/boundary/no_boundary.hpp>
#include <riprap/dynamics/damping/no_damping.hpp>
#include <riprap/simulation/simulation.hpp>
using namespace riprap;

struct MeanAngle {  // the friction angle of a pair is the mean of both; springs in series
  template <ContactLaw Law>
  Law operator()(const Law& a, const Law& b, const MaterialPair& pair) const {
    Law mixed = MixByParameter{}(a, b, pair);
    mixed.friction = std::tan(0.5 * (std::atan(a.friction) + std::atan(b.friction)));
    return mixed;
  }
};

int main() {
  const LinearSpringCoulomb rock{.friction = std::tan(40.0_deg)};
  const LinearSpringCoulomb steel{.normal_stiffness = 2e8, .friction = std::tan(20.0_deg)};
  const MixedContactLaw law{std::vector{rock, steel}, MeanAngle{}};
  // A slab of rock slides along a wall of steel.
  const ConvexPolygon slab{{-0.05, 0}, {0.05, 0}, {0.05, 0.005}, {-0.05, 0.005}};
  const ConvexPolygon wall{{-1, -0.1}, {1, -0.1}, {1, 0}, {-1, 0}};
  const Assembly assembly{.particles = {{.polygon = slab, .velocity = {1, 0}},
                                        {.polygon = wall, .motion = Motion::wall, .material = 1}}};
  const Rocks rocks{Rock{}, Rock{.young = 200e9, .poisson = 0.3, .density = 7850}};
  Simulation sim{
      Model{}.contact_law(law).boundary(NoBoundary{}).damping(NoDamping{}).criterion(NeverFails{}),
      assembly, rocks};
  sim.set_body_force({0, -9.81});
  while (sim.time() < 0.05) sim.step();
  const double slowed = 1 - sim.particles().body(0).velocity.x();
  return std::abs(slowed / (std::tan(30.0_deg) * 9.81 * 0.05) - 1) < 0.02 ? 0 : 1;
}
