// SPDX-License-Identifier: BSL-1.0
// riprap: the boundary of a BiaxialTest must have region(const Particles&) const with area(),
// semi_axes(), solid_area() and lost()
#include <riprap/experiment/biaxial_test.hpp>
#include <riprap/simulation/simulation.hpp>
using namespace riprap;

struct Mine {
  void drive(std::vector<Body>&, double) {}
  void set_rate(double, double) {}
  double region(const Particles&) const { return 1; }
};

void run(Simulation<decltype(Model{}.boundary(Mine{}))>& sim) { (void)BiaxialTest{}.run(sim); }
