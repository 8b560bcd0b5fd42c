// SPDX-License-Identifier: BSL-1.0
#include <riprap/measurement/friction_for_porosity.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <riprap/contact/contact_law/with_friction.hpp>
#include <riprap/dynamics/boundary/periodic_cell.hpp>
#include <riprap/measurement/average_stress.hpp>
#include <riprap/measurement/porosity.hpp>
#include <riprap/measurement/sieve_classes.hpp>
#include <riprap/particle/random_box_assembly.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

// A curve that rises steeply at first, as that of samples does.
double curve(double friction) { return 0.15 + 0.06 * (1 - std::exp(-6 * friction)); }

/// Porosity of a sample when it jams, compacted with a friction.
double compacted(const RandomAssembly& options, double friction) {
  const auto law = with_friction(EnergyConservingSpring{}, friction);
  Simulation sim{Model{}.criterion(NeverFails{}).boundary(PeriodicCell{}).contact_law(law),
                 random_periodic_assembly(options), Rock{}};
  const auto stress = [&] {
    const double area = sim.boundary().region(sim.particles()).area();
    return average_stress(sim.contacts(), area, sim.particles().thickness()).mean();
  };
  const double rate = 3;
  for (BodyIndex i = 0; i < sim.particles().size(); ++i)
    sim.set_velocity(i, -rate * sim.particles().body(i).position);
  sim.boundary().set_rate(rate, rate);
  int calm = 0;
  while (calm < 200) {
    sim.step();
    calm = stress() > 3e5 ? calm + 1 : 0;
  }
  return porosity(sim.boundary().region(sim.particles()), sim.contacts());
}

}  // namespace

TEST_CASE("the friction for a porosity is found on a curve that rises") {
  for (const double target : {0.1503, 0.16, 0.18, 0.205}) {
    CAPTURE(target);
    FrictionForPorosity search(target, 0.5, 1e-5);
    int samples = 0;
    for (; !search.found() && samples < 20; ++samples) search.add(curve(search.friction()));
    CHECK(search.found());
    CHECK(curve(search.friction()) == near(target, 1e-5));
    CHECK(samples <= 12);
  }
}

TEST_CASE("no friction, or all of it, may be what it takes") {
  FrictionForPorosity none(0.15, 0.5);
  none.add(0.1505);
  CHECK(none.found());
  CHECK(none.friction() == 0);
  FrictionForPorosity all(0.2, 0.5);
  all.add(0.15);
  CHECK(all.friction() == 0.5);
  all.add(0.1995);
  CHECK(all.found());
  CHECK(all.friction() == 0.5);
}

TEST_CASE("porosities out of reach are refused") {
  FrictionForPorosity dense(0.1, 0.5);
  CHECK_THROWS_WITH_AS(dense.add(0.15),
                       "FrictionForPorosity: target = 0.1: must be above the porosity without "
                       "friction, 0.150000",
                       InvalidInput);
  FrictionForPorosity loose(0.3, 0.5);
  loose.add(0.15);
  CHECK_THROWS_AS(loose.add(0.2), InvalidInput);
  CHECK_THROWS_AS(FrictionForPorosity(0, 0.5), InvalidInput);
  CHECK_THROWS_AS(FrictionForPorosity(0.2, -1), InvalidInput);
  CHECK_THROWS_AS(loose.add(1.2), InvalidInput);
}

TEST_CASE("the more friction a sample is compacted with, the looser it jams") {
  const RandomAssembly assembly{.count = 100, .seed = 2};
  const double dense = compacted(assembly, 0);
  const double middle = compacted(assembly, 0.2);
  const double loose = compacted(assembly, 1);
  CHECK(dense + 0.005 < middle);
  CHECK(middle + 0.005 < loose);
}

TEST_CASE("a porosity is met with sizes and shapes of one's own") {
  const Grading wide = Grading::of_sieves({{0.008, 0}, {0.016, 0.4}, {0.03, 1}});
  const RandomAssembly assembly{.count = 100,
                                .seed = 3,
                                .diameters = sieve_class_diameters(wide, 100),
                                .prescribed_shape =
                                    PrescribedShape{.elongation = Distribution::uniform(1.6, 2.2)}};
  const double dense = compacted(assembly, 0);
  const double loose = compacted(assembly, 1);
  CHECK(dense + 0.02 < loose);
  const double target = 0.5 * (dense + loose);
  // Porosities of a hundred particles scatter from friction to friction.
  FrictionForPorosity search(target, 1, 3e-3);
  search.add(dense);
  search.add(loose);
  int samples = 0;
  for (; !search.found() && samples < 15; ++samples)
    search.add(compacted(assembly, search.friction()));
  CHECK(search.found());
  CHECK(search.friction() > 0.01);
  CHECK(search.friction() < 0.9);
}
