// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <riprap/contact/contact_law/energy_conserving_spring.hpp>
#include <riprap/contact/contact_law/linear_spring_coulomb.hpp>
#include <riprap/contact/narrow_phase/overlap_chord.hpp>
#include <riprap/contact/narrow_phase/overlap_moments.hpp>
#include <riprap/dynamics/boundary/concepts.hpp>
#include <riprap/dynamics/boundary/periodic_cell.hpp>
#include <riprap/experiment/biaxial_test.hpp>
#include <riprap/experiment/curve.hpp>
#include <riprap/measurement/energy.hpp>
#include <riprap/output/csv.hpp>
#include <riprap/particle/random_assembly.hpp>
#include <riprap/particle/random_box_assembly.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near_relative;

namespace {

auto energy_conserving() {
  return Model{}.narrow_phase(OverlapMoments{}).contact_law(EnergyConservingSpring{});
}

/// Compares stored energy, linear and angular momentum before and after each check with breaks.
struct Breaks {
  bool keeps_momentum = true;
  double stored = 0;
  Vec2 momentum{0, 0};
  double angular = 0;
  int count = 0;
  double largest_rise = 0;  ///< of stored energy, as a share of it

  template <class Sim>
  static Vec2 linear(const Sim& sim) {
    Vec2 sum{0, 0};
    for (const Body& body : sim.particles().bodies())
      if (body.is_free()) sum += body.mass * body.velocity;
    return sum;
  }
  template <class Sim>
  static double turning(const Sim& sim) {
    double sum = 0;
    for (const Body& body : sim.particles().bodies())
      if (body.is_free())
        sum +=
            body.mass * cross(body.position, body.velocity) + body.inertia * body.angular_velocity;
    return sum;
  }
  template <class Sim>
  void before_splits(const Sim& sim) {
    stored = stored_energy(sim.contacts());
    momentum = linear(sim);
    angular = turning(sim);
  }
  template <class Sim>
  void after_splits(const Sim& sim) {
    ++count;
    largest_rise = std::max(largest_rise, stored_energy(sim.contacts()) / stored - 1);
    if (!keeps_momentum) return;
    const double mass = sim.particles().mean_density() * sim.particles().thickness() * 0.1;
    CHECK((linear(sim) - momentum).norm() <= 1e-12 * mass);
    CHECK(std::abs(turning(sim) - angular) <= 1e-12 * mass);
  }
};

template <class ModelType>
void shear(const ModelType& model, const Assembly& assembly, double pressure) {
  Simulation sim{model, assembly, Rock{}};
  Curve curve;
  Breaks breaks;
  BiaxialTest{.confining_pressure = pressure, .axial_strain = 0.1}.run(sim, curve, breaks);
  CHECK(breaks.count > 10);
  // Round-off of sums over some hundred contacts.
  CHECK(breaks.largest_rise <= 1e-12);
  const EnergyTerms& energy = curve.points().back().energy;
  // The work of the contacts is a trapezoid sum: an error of second order in the step.
  CHECK(std::abs(energy.law_residual) < 1e-3 * energy.boundary_work);
  // The mass floor gives light pieces kinetic energy.
  CHECK(energy.made() < 0.01 * energy.boundary_work);
}

}  // namespace

TEST_CASE("stored energy never rises at a break, and the contacts make none") {
  shear(energy_conserving(), random_assembly({.count = 150, .seed = 1}), 14e6);
  shear(energy_conserving().boundary(PeriodicCell{}),
        random_periodic_assembly({.count = 100, .seed = 2}), 16e6);
}

TEST_CASE("dust takes its rock and its energy with it, and leaves the rest in order") {
  const auto check = [](const auto& model, const Assembly& assembly, double pressure) {
    Simulation sim{model, assembly, Rock{}};
    const std::size_t particles = sim.particles().size();
    const double rock = rock_area(sim.particles());
    Curve curve;
    Breaks breaks{.keeps_momentum = false};
    BiaxialTest{.confining_pressure = pressure, .axial_strain = 0.1}.run(sim, curve, breaks);
    const std::vector<DustPiece>& dust = sim.particles().dust();
    REQUIRE(dust.size() > 10);
    CHECK(sim.particles().size() + dust.size() == particles + sim.breaks().size());
    CHECK(rock_area(sim.particles()) == near_relative(rock, 1e-12));
    std::vector<double> areas;
    for (const BreakEvent& event : sim.breaks())
      for (std::size_t k = 0; k < 2; ++k)
        if (event.pieces[k] == no_particle) areas.push_back(event.areas[k]);
    REQUIRE(areas.size() == dust.size());
    for (std::size_t k = 0; k < areas.size(); ++k) CHECK(dust[k].area == areas[k]);
    CHECK(breaks.largest_rise <= 1e-12);
    const EnergyTerms& energy = curve.points().back().energy;  // limits as without dust
    CHECK(std::abs(energy.law_residual) < 1e-3 * energy.boundary_work);
    CHECK(energy.made() < 0.01 * energy.boundary_work);
  };
  const auto model = energy_conserving().splitter(StraightCut{.dust = true});
  check(model, random_assembly({.count = 150, .seed = 1}), 14e6);
  check(model.boundary(PeriodicCell{}), random_periodic_assembly({.count = 100, .seed = 2}), 16e6);
}

TEST_CASE("the chord model makes energy of the order of a tenth of the work in the same test") {
  Simulation sim{Model{}.narrow_phase(OverlapChord{}).contact_law(LinearSpringCoulomb{}),
                 random_assembly({.count = 150, .seed = 1}), Rock{}};
  Curve curve;
  BiaxialTest{.confining_pressure = 14e6, .axial_strain = 0.1}.run(sim, curve);
  const EnergyTerms& energy = curve.points().back().energy;
  CHECK(energy.made() > 0.05 * energy.boundary_work);
}
