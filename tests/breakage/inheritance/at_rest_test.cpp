// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/inheritance/at_rest.hpp>
#include <riprap/contact/contact_law/linear_spring_coulomb.hpp>

#include <doctest/doctest.h>

#include <riprap/dynamics/boundary/no_boundary.hpp>
#include <riprap/dynamics/damping/no_damping.hpp>
#include <riprap/measurement/energy_ledger.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/crushing.hpp>
#include <support/near.hpp>

using namespace riprap;

namespace {

/// Kinetic energy on both sides of a split [J].
struct AroundSplit {
  double before = 0;
  double after = -1;
  void before_splits(const auto& sim) { before = kinetic_energy(sim.particles()); }
  void after_splits(const auto& sim) { after = kinetic_energy(sim.particles()); }
};

}  // namespace

TEST_CASE("pieces start at rest, and the ledger books the kinetic energy that they lack") {
  const auto smooth = Model{}.contact_law(LinearSpringCoulomb{.friction = 0}).damping(NoDamping{});
  const auto crush = [](const auto& model, AroundSplit& around) {
    Simulation sim{model.boundary(NoBoundary{}), test::square_between_platens(0.2), Rock{}};
    // Adrift between smooth platens.
    sim.set_velocity(0, {0.3, 0});
    EnergyLedger ledger;
    ledger.open(sim);
    while (sim.breaks().empty()) sim.step(around, ledger);
    return ledger.terms(sim).breakage;
  };
  AroundSplit kept;
  AroundSplit lost;
  const double breakage = crush(smooth, kept);
  const double breakage_at_rest = crush(smooth.inheritance(AtRest{}), lost);
  CHECK(lost.before > 4e-4);  // of 0.01 kg at 0.3 m/s
  CHECK(lost.before == kept.before);
  CHECK(lost.after == 0);
  // Both ledgers hold stored energy of the order of 1 J.
  CHECK(breakage_at_rest - breakage == test::near_relative(kept.after, 1e-9));
}
