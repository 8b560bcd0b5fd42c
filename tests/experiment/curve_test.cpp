// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include <riprap/bond/bond_law/brittle_bond.hpp>
#include <riprap/contact/contact_law/linear_spring_coulomb.hpp>
#include <riprap/contact/narrow_phase/overlap_chord.hpp>
#include <riprap/dynamics/boundary/periodic_cell.hpp>
#include <riprap/experiment/curve.hpp>
#include <riprap/particle/bonded_cells.hpp>
#include <riprap/particle/random_box_assembly.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/near.hpp>
#include <support/still_sample.hpp>

using namespace riprap;
using riprap::test::near;
using riprap::test::near_relative;

namespace {

// Depths of 1e-5 m in coordinates of 1e-2 m have lost four of sixteen digits.
constexpr double digits = 1e-11;

constexpr double stiffness = 2e7;  // [N/m]
constexpr double reach = 0.012;    // [m]
constexpr double thickness = 0.016;

/// Forces of 200 N along axis 1 and 600 N along axis 2.
const test::Cross loaded{.depths = {1e-5, 3e-5, 1e-5, 3e-5}};

struct Scene {
  explicit Scene(const test::Cross& cross = loaded) : sample(cross) {}

  test::StillSample sample;
  BiaxialView<test::StillSample> view = test::view_of(sample);

  [[nodiscard]] CurvePoint measured() const {
    Curve curve;
    curve.record(view);
    return curve.points().at(0);
  }
};

/// Springs that own up to half of what they store: the other half is the law's residual.
struct HalfStated : LinearSpringCoulomb {
  [[nodiscard]] double stored_energy(const ContactGeometry& geometry,
                                     const History& history) const {
    return 0.5 * LinearSpringCoulomb::stored_energy(geometry, history);
  }
};
static_assert(ContactLaw<HalfStated>);

template <class Law>
auto unbreakable(const Law& law) {
  return Model{}
      .criterion(NeverFails{})
      .narrow_phase(OverlapChord{})
      .contact_law(law)
      .time_step(MassFloor{.fraction = 0.12});
}

constexpr int steps = 400;
const Vec2 rate{0.4, 0.9};  // [1/s]

/// What symplectic Euler leaves over: in each step the boundary's work is booked with the force
/// before it, that of the contacts with the mean of before and after. The difference, dt v dF / 2
/// for each driven square, does not grow with the number of steps but with the change of force.
template <class Sim>
test::Near lag_of_leapfrog(const Sim& sim) {
  const double dt = sim.time_step();
  const Vec2 speed = reach * rate;
  const Vec2 force = stiffness * steps * dt * speed;  // by which each contact on an axis grows
  // The squares, and so their speeds, come nearer by 0.1 % on the way.
  return near_relative(-dt * speed.dot(force), 2e-3);
}

/// Squeezes the sample for some steps and gives the energy booked at the end.
template <class Sim>
EnergyTerms energy_of_squeeze(Sim& sim, Stage stage) {
  BiaxialView<Sim> view{.sim = sim, .stage = stage};
  view.mean_diameter = 0.016;
  view.area = sim.boundary().region(sim.particles()).area();
  Curve curve;
  curve.begin_stage(view);
  sim.boundary().set_rate(rate.x(), rate.y());
  for (int n = 0; n < steps; ++n) sim.step(curve);
  curve.record(view);
  return curve.points().back().energy;
}

}  // namespace

TEST_CASE("strains are those of the view, and the stress is that of its area") {
  Scene scene;
  scene.view.stretch = {1.03, 0.85};
  const CurvePoint p = scene.measured();
  CHECK(p.axial_strain == scene.view.axial_strain());
  CHECK(p.volumetric_strain == scene.view.volumetric_strain());
  // Two contacts on each axis: sigma = 2 f l / (A t), with A = 2 reach^2 of the diamond.
  CHECK(p.stress.s11 == near_relative(200 / (reach * thickness), digits));
  CHECK(p.stress.s22 == near_relative(600 / (reach * thickness), digits));
  CHECK(p.stress.s12 == near(0, digits * p.stress.s22));
  CHECK(p.sin_phi() == near_relative(0.5, digits));
  scene.view.area *= 2;
  CHECK(scene.measured().stress.s22 == near_relative(0.5 * p.stress.s22, 1e-15));
  // The inner ellipse, 0.65 of the extent, holds 0.65 of every branch.
  const double inner = 0.65 * reach;
  CHECK(p.inner_stress.s22 ==
        near_relative(2 * 600 * inner / (std::numbers::pi * inner * inner * thickness), digits));
  CHECK(p.inner_sin_phi() == near_relative(0.5, digits));
  CHECK(scene.measured().inner_stress.s22 == p.inner_stress.s22);
}

TEST_CASE("porosity counts the rock within the boundary once") {
  const CurvePoint p = Scene().measured();
  // The free square, a quarter of each driven one, less four overlaps as wide as the driven square.
  double rock = 0.016 * 0.016;
  for (std::size_t i = 0; i < 4; ++i) {
    const double h = loaded.driven_half(i);
    rock += h * h - loaded.depths[i] * 2 * h;
  }
  CHECK(p.porosity == near(1 - rock / (2 * reach * reach), 1e-13));
}

TEST_CASE("contacts, particles and lost particles are counted") {
  Scene scene;
  const CurvePoint p = scene.measured();
  CHECK(p.coordination.coordination_number == 4);
  CHECK(p.coordination.contacts_per_particle == 2);
  CHECK(p.particles == 5);
  CHECK(p.lost_particles == 0);
  scene.sample.body(0).position = {0.011, 0.011};
  CHECK(scene.measured().lost_particles == 1);
}

TEST_CASE("a cross of four contacts has the strength that its force anisotropy says") {
  // a = 0, a_n = 2 (600 - 200) / (600 + 200) = 1 along axis 2, branches of one length along
  // normals.
  const CurvePoint p = Scene().measured();
  CHECK(p.fabric.normals.coefficient == near(0, 1e-15));
  CHECK(p.fabric.normal_forces.coefficient == near_relative(1, digits));
  CHECK(p.fabric.mean_normal_force == near_relative(400, digits));
  CHECK(p.sin_phi_fabric() == near_relative(0.5, digits));
  CHECK(p.sin_phi_fabric_simplified() == near_relative(0.5, digits));
  CHECK(p.sin_phi_fabric_full() == near_relative(0.5, digits));
}

TEST_CASE(
    "strength from fabric is taken along axis 2: a sample loaded along axis 1 has it negative") {
  const CurvePoint p = Scene(test::Cross{.depths = {3e-5, 1e-5, 3e-5, 1e-5}}).measured();
  CHECK(p.sin_phi() == near_relative(-0.5, digits));
  CHECK(p.sin_phi_fabric() == near_relative(-0.5, digits));
  CHECK(p.sin_phi_fabric_simplified() == near_relative(-0.5, digits));
  CHECK(p.sin_phi_fabric_full() == near_relative(-0.5, digits));
}

TEST_CASE("the state of the sample is in dimensionless numbers") {
  Scene scene;
  scene.view.rate = {-7, 0.02};
  const CurvePoint p = scene.measured();
  CHECK(p.inertial_number ==
        near_relative(0.02 * 0.016 * std::sqrt(2500 / (400 / (reach * thickness))), digits));
  CHECK(p.overlap_ratio == near_relative(2e-5 / 0.016, digits));
  CHECK(p.state.contacts == 4);
  CHECK(p.state.mean_normal_force == near_relative(400, digits));
  CHECK(p.state.unbalanced_force == near(0, digits));
  // 1/2 k depth^2 in each contact.
  CHECK(p.state.stored_energy == near_relative(stiffness * (1e-10 + 9e-10), digits));
  // A body force that no contact carries is out of balance: m g over the mean contact force.
  scene.sample.set_body_force({0, -9.81});
  const double weight = 2500 * 0.016 * 0.016 * thickness * 9.81;
  CHECK(scene.measured().state.unbalanced_force == near(weight / 400, digits));
}

TEST_CASE("each record is a point; the peak is the one with the largest sin phi") {
  Curve curve;
  for (const double depth : {1e-5, 2e-5, 4e-5, 3e-5}) {
    Scene scene(test::Cross{.depths = {1e-5, depth, 1e-5, depth}});
    curve.record(scene.view);
  }
  REQUIRE(curve.points().size() == 4);
  CHECK(&curve.peak() == &curve.points()[2]);
  CHECK(curve.peak().sin_phi() == near_relative(0.6, digits));
}

TEST_CASE("breakages are counted from the start of shear; earlier ones apart") {
  Scene scene;
  Curve curve;
  scene.view.stage = Stage::hydrostatic;
  curve.begin_stage(scene.view);
  scene.sample.breaks().resize(4);
  CHECK(curve.breakages_before_shear() == 0);
  scene.view.stage = Stage::shear;
  curve.begin_stage(scene.view);
  CHECK(curve.breakages_before_shear() == 4);
  curve.record(scene.view);
  scene.sample.breaks().resize(7);
  curve.record(scene.view);
  CHECK(curve.points()[0].breakages == 0);
  CHECK(curve.points()[1].breakages == 3);
}

TEST_CASE("every break is kept with its stage and the strain at which it came") {
  Scene scene;
  Curve curve;
  BreakEvent event;
  scene.view.stage = Stage::hydrostatic;
  event.particle.id = 11;
  curve.record_break(scene.view, event);
  scene.view.stage = Stage::shear;
  scene.view.stretch = {1.1, 0.875};
  event.particle.id = 12;
  curve.record_break(scene.view, event);
  REQUIRE(curve.breaks().size() == 2);
  CHECK(curve.breaks()[0].stage == Stage::hydrostatic);
  CHECK(curve.breaks()[0].axial_strain == 0);
  CHECK(curve.breaks()[0].event.particle.id == 11);
  CHECK(curve.breaks()[1].stage == Stage::shear);
  CHECK(curve.breaks()[1].axial_strain == 0.125);
  CHECK(curve.breaks()[1].event.particle.id == 12);
}

TEST_CASE("the energy error is the share of the boundary's work that the terms leave over") {
  CurvePoint p;
  CHECK(p.energy_error() == 0);
  p.energy.boundary_work = 8;
  p.energy.stored = 5;
  p.energy.slip = 2;
  CHECK(p.energy_error() == 0.125);
}

TEST_CASE("the energy terms of a curve are those of the simulation") {
  Simulation sim{unbreakable(LinearSpringCoulomb{}), loaded.assembly(), Rock{}};
  const EnergyTerms e = energy_of_squeeze(sim, Stage::shear);
  CHECK(e.boundary_work > 0);
  CHECK(e.stored > 0);
  // Head-on springs are linear, so that the trapezoid sum of their work is exact.
  CHECK(e.law_residual == near(0, 1e-9 * e.boundary_work));
  CHECK(e.unclosed() == lag_of_leapfrog(sim));
}

TEST_CASE("energy that a contact law does not state is booked as its residual and nowhere else") {
  Simulation full{unbreakable(LinearSpringCoulomb{}), loaded.assembly(), Rock{}};
  Simulation halved{unbreakable(HalfStated{}), loaded.assembly(), Rock{}};
  const EnergyTerms e = energy_of_squeeze(full, Stage::shear);
  const EnergyTerms half = energy_of_squeeze(halved, Stage::shear);
  // The forces are the same, hence the motion and the work.
  CHECK(half.boundary_work == e.boundary_work);
  CHECK(half.stored == near_relative(0.5 * e.stored, 1e-12));
  CHECK(half.law_residual == near_relative(0.5 * e.stored, 1e-9));
  CHECK(half.unclosed() == lag_of_leapfrog(halved));
}

TEST_CASE("the energy ledger is of shear alone: it does not open in an earlier stage") {
  Simulation sim{unbreakable(HalfStated{}), loaded.assembly(), Rock{}};
  const EnergyTerms e = energy_of_squeeze(sim, Stage::hydrostatic);
  CHECK(e.law_residual == 0);
  // Opened late, it counts from there: what the sample has been through before is not in it.
  const EnergyTerms late = energy_of_squeeze(sim, Stage::shear);
  // The squares are 0.1 % nearer, and slower, from the start.
  CHECK(late.unclosed() == near_relative(lag_of_leapfrog(sim).expected, 4e-3));
  CHECK(late.boundary_work < sim.work().boundary);
}

TEST_CASE("a curve takes clusters of bonded cells for particles") {
  Simulation sim{Model{}
                     .boundary(PeriodicCell{})
                     .criterion(NeverFails{})
                     .bond_law(BrittleBond{.tensile_strength = 1e30, .cohesion = 1e30}),
                 bonded_cells(random_periodic_assembly({.count = 30}), {.count = 5, .seed = 1}),
                 Rock{}};
  REQUIRE(sim.particles().size() == 150);
  sim.boundary().set_rate(50, 50);
  for (int n = 0; n < 20'000 && fragment_coordination(sim).coordination_number < 1; ++n) sim.step();
  BiaxialView<decltype(sim)> view{.sim = sim, .stage = Stage::shear};
  view.mean_diameter = 0.016;
  view.area = sim.boundary().region(sim.particles()).area();
  Curve curve;
  curve.begin_stage(view);
  curve.record(view);
  CHECK(curve.points()[0].particles == 30);
  CHECK(curve.points()[0].breakages == 0);
  CHECK(curve.points()[0].coordination.coordination_number >= 1);
  CHECK(coordination(sim.contacts(), sim.particles()).coordination_number < 1);
  const ParticleId first = sim.particles().ancestry(0).root;
  sim.break_bonds([&](const auto& bond) { return sim.particles().ancestry(bond.a).root == first; });
  sim.step();
  curve.record(view);
  CHECK(curve.points()[1].particles == 34);
  CHECK(curve.points()[1].breakages == 4);
}
