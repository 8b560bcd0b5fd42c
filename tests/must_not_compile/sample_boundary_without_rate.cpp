// SPDX-License-Identifier: BSL-1.0
// riprap: the boundary of a BiaxialTest must have void set_rate(double, double), as StrainField,
// RigidPlatens and PeriodicCell do
#include <riprap/experiment/biaxial_test.hpp>
#include <riprap/simulation/simulation.hpp>
using namespace riprap;

struct Mine {
  void drive(std::vector<Body>&, double) {}
  BoundaryPolygon region(const Particles& particles) const { return BoundaryPolygon(particles); }
};

void run(Simulation<decltype(Model{}.boundary(Mine{}))>& sim) { (void)BiaxialTest{}.run(sim); }
