// SPDX-License-Identifier: BSL-1.0
#include <riprap/measurement/contact_stress.hpp>

#include <doctest/doctest.h>

#include <riprap/measurement/average_stress.hpp>
#include <riprap/particle/random_assembly.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/near.hpp>
#include <support/still_sample.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

void check_same(const Stress2& measured, const Stress2& expected, double tolerance) {
  CHECK(measured.s11 == near(expected.s11, tolerance));
  CHECK(measured.s22 == near(expected.s22, tolerance));
  CHECK(measured.s12 == near(expected.s12, tolerance));
}

/// The stress of the elements of particle i, which has not turned yet, averaged over its area.
template <class Sim>
Stress2 mean_element_stress(const Sim& sim, BodyIndex i) {
  const ElementStress stress = sim.element_stress(i);
  const Mesh& mesh = sim.mesh(i);
  Stress2 sum;
  double area = 0;
  for (std::size_t e = 0; e < stress.size(); ++e) {
    sum += mesh.area(e) * stress[e];
    area += mesh.area(e);
  }
  return (1 / area) * sum;
}

}  // namespace

TEST_CASE("a square pressed from four sides has force over area on each pair of them") {
  // 250 N along axis 1 and 400 N along axis 2, through the middle of the overlaps.
  const Cross cross{.depths = {1.25e-5, 2e-5, 1.25e-5, 2e-5}};
  const StillSample sample(cross);
  const Stress2 stress = contact_stresses(sample.contacts(), sample.particles())[0];
  // The points of contact lie within the depth of the sides, 2e-5 of 0.008 m.
  const double side = 2 * cross.half * cross.thickness;
  check_same(stress, {250 / side, 400 / side, 0}, 2.5e-3 * 400 / side);
}

TEST_CASE("a turned sample has the same stress in turned axes") {
  const Cross cross{.depths = {1.25e-5, 2e-5, 1.25e-5, 2e-5}};
  Cross turned = cross;
  turned.turn = 0.3;
  const StillSample sample(turned);
  const Stress2 upright =
      contact_stresses(StillSample(cross).contacts(), StillSample(cross).particles())[0];
  // Round-off of depths of 1e-5 m from coordinates of 1e-2 m.
  check_same(contact_stresses(sample.contacts(), sample.particles())[0],
             upright.rotated(Rotation::from_angle(0.3)), 1e-9 * upright.s22);
}

TEST_CASE("tangential forces count, and turning moments that do not balance leave s12 symmetric") {
  StillSample sample;
  sample.slide(3e-6);
  // Shear of k_t times the slide, all four of them turning the square the same way: x_1 f_2 and
  // x_2 f_1 cancel.
  const Stress2 stress = contact_stresses(sample.contacts(), sample.particles())[0];
  CHECK(stress.s12 == near(0, 1e-9 * stress.s11));
}

TEST_CASE("weighted by area the particles add up to the stress of the assembly") {
  Simulation sim{Model{}.criterion(NeverFails{}), random_assembly({.count = 120, .seed = 4}),
                 Rock{}};
  sim.boundary().set_rate(20, 5);
  for (int i = 0; i < 4000; ++i) sim.step();
  const auto stresses = contact_stresses(sim.contacts(), sim.particles());
  Stress2 sum;
  for (BodyIndex i = 0; i < sim.particles().size(); ++i)
    sum += sim.particles().shape(i).area * stresses[i];
  const Stress2 assembly = average_stress(sim.contacts(), 1, sim.particles().thickness());
  REQUIRE(assembly.mean() > 0);
  check_same(sum, assembly, 1e-12 * assembly.mean());
}

TEST_CASE("it is the mean of the stresses of the finite elements in a particle at rest") {
  const Cross cross{.depths = {1.25e-5, 2e-5, 1.25e-5, 2e-5}, .turn = 0.3};
  const Simulation sim{Model{}, cross.assembly(), Rock{}};
  const Stress2 mean = mean_element_stress(sim, 0);
  // Elements are loaded at the nearest place on the side, half a depth from the point of contact.
  check_same(contact_stresses(sim.contacts(), sim.particles())[0], mean, 2.5e-3 * mean.s22);
}
