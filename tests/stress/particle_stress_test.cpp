// SPDX-License-Identifier: BSL-1.0
#include <riprap/stress/particle_stress.hpp>

#include <doctest/doctest.h>

#include <riprap/dynamics/boundary/no_boundary.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/crushing.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near_relative;

TEST_CASE("the mean stress of a particle under gathered contacts is that of its forces") {
  Simulation sim{Model{}.boundary(NoBoundary{}), test::square_between_platens(0.2), Rock{}};
  sim.set_breakage(false);
  for (int i = 0; i < 1500; ++i) sim.step();
  // A point in time at which the square also turns and shifts in its own frame is not needed: the
  // platens load it symmetrically, s22 of the mean is the force over width and thickness.
  double force = 0;
  sim.contacts().for_each_touching([&](const auto& c) { force += 0.5 * c.force.normal; });
  REQUIRE(force > 100);
  const ElementStress stress = sim.element_stress(0);
  const Mesh& mesh = sim.mesh(0);
  double mean = 0;
  for (std::size_t e = 0; e < mesh.size(); ++e) mean += mesh.area(e) * stress[e].s22;
  mean /= 0.016 * 0.016;
  // The forces act at the boundary; their places differ from it by half the overlap at most, which
  // the projection onto the boundary takes away. What is left is the imbalance of the two forces.
  CHECK(mean == near_relative(force / (0.016 * 0.016), 1e-6));
}

TEST_CASE("stresses are those of the loads in the particle's own frame, times the scale") {
  Particles particles(0.016, 2500);
  particles.add(ConvexPolygon{{0, 0}, {0.016, 0}, {0.016, 0.016}, {0, 0.016}}, Motion::free);
  const StressModel<> model{};
  const auto op = build_operator(model, Rock{}, particles, 0);
  // A pressure of 100 N on each of two opposite sides, in a body that is turned.
  const Rotation rotation = Rotation::from_angle(0.7);
  const std::vector<ContactLoad> loads{
      {rotation * Vec2{-0.008, 0}, rotation * Vec2{100, 0}, 100, 1},
      {rotation * Vec2{0.008, 0}, rotation * Vec2{-100, 0}, 100, 2}};
  StressEvaluation evaluate;
  const ElementStress stress = evaluate(*op, model.support, rotation, loads, 3);
  double mean = 0;
  for (std::size_t e = 0; e < stress.size(); ++e) mean += op->mesh().area(e) * stress[e].s11;
  // The mean stress is the sum of arm times force over the volume.
  CHECK(mean / (0.016 * 0.016) == near_relative(3 * 100 / (0.016 * 0.016), 1e-9));
}
