// SPDX-License-Identifier: BSL-1.0
#include <riprap/bond/bond_law/brittle_bond.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::message_of;

namespace {

constexpr BrittleBond law{.normal_stiffness = 4e11,
                          .tangential_stiffness = 1e11,
                          .tensile_strength = 8e6,
                          .cohesion = 12e6,
                          .friction = 0.6};

/// Uniform along the edge.
BondFailure failure(double tension, double shear) {
  const BondDisplacement d{tension / law.normal_stiffness, shear / law.tangential_stiffness};
  return law.failure({.ends = {d, d}, .points = {d, d}});
}

}  // namespace

TEST_CASE("strength is Mohr-Coulomb with a tension cut-off") {
  // Just below and just above the line c + mu p, in compression and in tension.
  for (const double pressure : {-7e6, -3e6, 0.0, 5e6, 80e6})
    for (const double sign : {-1.0, 1.0}) {
      const double shear = sign * (12e6 + 0.6 * pressure);
      CHECK(failure(-pressure, 0.999999 * shear) == BondFailure::none);
      CHECK(failure(-pressure, 1.000001 * shear) == BondFailure::shear);
    }
  CHECK(failure(7.999999e6, 0) == BondFailure::none);
  CHECK(failure(8.000001e6, 0) == BondFailure::tension);
  CHECK(failure(8.000001e6, 7e6) == BondFailure::tension);
  CHECK(failure(-1e12, 0) == BondFailure::none);
}

TEST_CASE("the extreme fibre decides: a bond fails when one end of its edge does") {
  const double opening = 8.000001e6 / law.normal_stiffness;
  BondView<BrittleBond::State> bent{.ends = {{{-opening, 0}, {opening, 0}}}};
  CHECK(law.failure(bent) == BondFailure::tension);
  bent.ends[1].opening = 0.999 * opening;
  CHECK(law.failure(bent) == BondFailure::none);
}

TEST_CASE("tractions push where edges overlap and pull where they are apart") {
  BrittleBond::State state;
  const BondTraction apart = law({1e-5, 2e-5}, state);
  CHECK(apart.normal == test::near_relative(-4e6, 1e-15));
  CHECK(apart.tangential == test::near_relative(-2e6, 1e-15));
  CHECK(apart.loss == 0);
  CHECK(law({-1e-5, 0}, state).normal == test::near_relative(4e6, 1e-15));
  CHECK(law.stored_energy({1e-5, 2e-5}, state) == test::near_relative(20 + 20, 1e-15));
  CHECK(law.peak_stiffness() == 4e11);
}

TEST_CASE("parameters that break a rule are named") {
  CHECK(message_of([] { BrittleBond{.normal_stiffness = 0}.validate(); }) ==
        "BrittleBond.normal_stiffness = 0: must be a finite number above 0");
  CHECK(message_of([] { BrittleBond{.cohesion = -1}.validate(); }) ==
        "BrittleBond.cohesion = -1: must be above 0");
  CHECK(message_of([] { BrittleBond{.tensile_strength = std::nan("")}.validate(); }) != "");
  CHECK(message_of([] { BrittleBond{.friction = -0.1}.validate(); }) != "");
  CHECK(message_of([] { BrittleBond{.tangential_stiffness = -1}.validate(); }) != "");
  CHECK(message_of([] { BrittleBond{}.validate(); }) == "");
}
