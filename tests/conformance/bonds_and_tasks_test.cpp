// SPDX-License-Identifier: BSL-1.0
// Results of bonded samples do not depend on tasks, threads and what only accelerates.

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <vector>

#include <riprap/bond/bond_law/brittle_bond.hpp>
#include <riprap/bond/bond_law/softening_bond.hpp>
#include <riprap/dynamics/boundary/periodic_cell.hpp>
#include <riprap/dynamics/damping/no_damping.hpp>
#include <riprap/dynamics/integrator/velocity_verlet.hpp>
#include <riprap/dynamics/time_step/no_mass_scaling.hpp>
#include <riprap/measurement/energy_ledger.hpp>
#include <riprap/particle/bond_common_edges.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/near.hpp>
#include <support/rectangle.hpp>
#ifdef _OPENMP
#include <riprap/core/execution/threads.hpp>
#endif

using namespace riprap;
using test::near;
using test::near_relative;
using test::rectangle;

namespace {

constexpr double side = 0.005;
constexpr int rows = 20;

/// Squares that fill a periodic cell, bonded: two tasks of bodies and three of bonds.
Assembly filled_cell() {
  Assembly assembly{.thickness = 0.016, .particles = {}};
  assembly.period = {rows * side, rows * side};
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < rows; ++j)
      assembly.particles.push_back(
          {rectangle({side * i, side * j}, side, side),
           Motion::free,
           {3 * std::sin(0.7 * i + 0.4 * j), 3 * std::cos(0.3 * i - 1.1 * j)}});
  bond_common_edges(assembly);
  return assembly;
}

auto model() {
  return Model{}
      .boundary(PeriodicCell{})
      .bond_law(BrittleBond{.tensile_strength = 2e6, .cohesion = 3e6})
      .criterion(HoekBrown{.compressive_strength = 10e6})
      .check_every(40);
}

template <class ModelType>
std::vector<double> run(const ModelType& model, int steps = 400) {
  Simulation sim{model, filled_cell(), Rock{}};
  sim.boundary().set_rate(20, -10);
  std::vector<double> numbers;
  for (int n = 0; n < steps; ++n) {
    sim.step();
    for (const Body& b : sim.particles().bodies())
      for (const double x : {b.position.x(), b.position.y(), b.rotation.sine, b.velocity.x(),
                             b.velocity.y(), b.angular_velocity})
        numbers.push_back(x);
    for (const double x : {sim.work().boundary, sim.work().damping, sim.bonds().loss(),
                           sim.bonds().stored_energy(0.016), sim.contacts().friction_loss()})
      numbers.push_back(x);
  }
  CHECK(sim.bonds().size() > 256);
  CHECK(sim.bond_breaks().size() > 20);
  CHECK(!sim.breaks().empty());
  CHECK(sim.contacts().friction_loss() > 0);
  return numbers;
}

bool same(const std::vector<double>& p, const std::vector<double>& q) {
  return p.size() == q.size() && std::memcmp(p.data(), q.data(), p.size() * sizeof(double)) == 0;
}

struct LastToFirst {
  template <class Work>
  void run(std::size_t tasks, Work&& work) const {
    while (tasks-- > 0) work(tasks);
  }
};

}  // namespace

TEST_CASE("a bonded sample runs the same for any order of tasks and any number of threads") {
  const std::vector<double> in_order = run(model());
  CHECK(same(run(model().execution(LastToFirst{})), in_order));
#ifdef _OPENMP
  for (const int threads : {1, 2, 4})
    CHECK(same(run(model().execution(Threads{threads})), in_order));
#endif
}

TEST_CASE("a bonded sample runs the same without acceleration") {
  CHECK(same(run(model().without_acceleration(), 250), run(model(), 250)));
}

namespace {

// Verlet's kinetic energy between two kicks of half a step differs from the trapezoids of the
// ledger by dt^2 / 8 sum of (F^2 / m + M^2 / I), which vanishes at the start.
template <class Sim>
double of_half_kicks(const Sim& sim) {
  double sum = 0;
  for (BodyIndex i = 0; i < sim.particles().size(); ++i) {
    const Body& body = sim.particles().body(i);
    Wrench total = sim.force_on(i);
    total.add(sim.bond_force_on(i).force, sim.bond_force_on(i).moment);
    sum += (total.force.dot(total.force) / body.mass + total.moment * total.moment / body.inertia) /
           body.mass_scaling;
  }
  return sim.time_step() * sim.time_step() / 8 * sum;
}

// `unclosed` is the most that may be left over, as a share of the energy at the start.
template <class ModelType>
void check_balance(const ModelType& model, double unclosed) {
  const auto verlet =
      model.integrator(VelocityVerlet{}).damping(NoDamping{}).time_step(NoMassScaling{});
  Simulation sim{verlet, filled_cell(), Rock{}};
  sim.boundary().set_rate(20, -10);
  EnergyLedger ledger;
  ledger.open(sim);
  const double start = kinetic_energy(sim.particles());
  for (int n = 0; n < 1200; ++n) sim.step(ledger);
  CHECK(sim.bond_breaks().size() > 5);
  const EnergyTerms terms = ledger.terms(sim);
  CHECK(terms.bonds == near_relative(sim.bonds().loss(), 1e-12));
  CHECK(terms.stored ==
        near(stored_energy(sim.contacts()) + sim.bonds().stored_energy(0.016), 1e-9 * start));
  CHECK(terms.bonds > 0.01 * start);
  CHECK(terms.unclosed() == near(-of_half_kicks(sim), unclosed * start));
  // Of the trapezoids, where bonds break and contacts begin.
  CHECK(std::abs(terms.law_residual) <= 0.02 * (start + std::abs(terms.boundary_work)));
  CHECK(terms.made() <= 0.02 * (start + std::abs(terms.boundary_work)));
}

}  // namespace

TEST_CASE("the balance of energy of a bonded sample closes") {
  const SofteningBond softening{
      .tensile_strength = 2e6, .shear_strength = 3e6, .fracture_energy = 40};
  // Round-off.
  check_balance(model().criterion(NeverFails{}), 1e-10);
  check_balance(model().criterion(NeverFails{}).bond_law(softening), 1e-10);
  // A break changes forces between the two kicks: an error of the order of the step.
  check_balance(model(), 1e-3);
  check_balance(model().bond_law(softening), 1e-3);
}
