// SPDX-License-Identifier: BSL-1.0
#include <riprap/bond/bond_law/softening_bond.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::message_of;
using test::near;
using test::near_relative;

namespace {

constexpr SofteningBond law{.normal_stiffness = 4e11,
                            .tangential_stiffness = 1e11,
                            .tensile_strength = 8e6,
                            .shear_strength = 12e6,
                            .fracture_energy = 3000};

}  // namespace

TEST_CASE("a point that is pulled apart in any direction dissipates the fracture energy") {
  // Whatever the steps: the loss of each is in closed form.
  for (const double angle : {0.0, 0.3, 0.9, 1.5707963267948966, -1.2})
    for (const int steps : {3, 50, 1000}) {
      SofteningBond::State state;
      double lost = 0;
      for (int n = 1; n <= steps; ++n) {
        const double apart = 1e-3 * n / steps;
        lost += law({apart * std::cos(angle), apart * std::sin(angle)}, state).loss;
      }
      CHECK(state.damage == 1);
      CHECK(lost == near_relative(3000, 1e-12));
    }
}

TEST_CASE("opening: the traction rises to the strength and falls linearly to zero") {
  const double first = 8e6 / 4e11;
  const double last = 2 * 3000 / 8e6;  // area of the triangle
  SofteningBond::State state;
  CHECK(law({first, 0}, state).normal == near_relative(-8e6, 1e-14));
  CHECK(state.damage == near(0, 1e-15));
  for (const double share : {0.2, 0.5, 0.9}) {
    const double opening = first + share * (last - first);
    CHECK(law({opening, 0}, state).normal == near_relative(-(1 - share) * 8e6, 1e-12));
  }
  CHECK(law({last * (1 + 1e-12), 0}, state).normal == 0);
  CHECK(law({last, 0}, state).loss == 0);
}

TEST_CASE("unloading is linear to the origin, nothing heals, and overlap is undamaged") {
  SofteningBond::State state;
  const double opening = 1e-4;
  const double traction = law({opening, 0}, state).normal;
  const double damage = state.damage;
  CHECK(damage > 0.1);
  const BondTraction half = law({0.5 * opening, 0}, state);
  CHECK(half.normal == near_relative(0.5 * traction, 1e-14));
  CHECK(half.loss == 0);
  CHECK(law({-opening, 0}, state).normal == 4e11 * opening);
  CHECK(state.damage == damage);
  CHECK(law({opening, 0}, state).normal == near_relative(traction, 1e-14));
  CHECK(law.stored_energy({-opening, 0}, state) ==
        near_relative(0.5 * 4e11 * opening * opening, 1e-14));
}

TEST_CASE("the work of the traction is what is stored and what is lost") {
  // Trapezoids of a traction that is linear between its kinks: the error is in the two steps that
  // hold a kink, each at most the strength times its length.
  SofteningBond::State state;
  constexpr int steps = 20'000;
  const double step = 2e-7;
  double work = 0;
  double lost = 0;
  double before = 0;
  for (int n = 1; n <= steps; ++n) {
    const BondTraction traction = law({n * step, 0}, state);
    work -= 0.5 * step * (before + traction.normal);
    lost += traction.loss;
    before = traction.normal;
    if (n == 1000 || n == steps)
      CHECK(lost + law.stored_energy({n * step, 0}, state) == near(work, 2 * 8e6 * step));
  }
}

TEST_CASE("a bond is gone when both points are damaged, by what damaged them") {
  const BondDisplacement open{1e-3, 0};
  const BondDisplacement slid{-1e-6, 1e-3};
  CHECK(law.failure({.points = {open, open}, .states = {{{1}, {0.99}}}}) == BondFailure::none);
  CHECK(law.failure({.points = {open, open}, .states = {{{1}, {1}}}}) == BondFailure::tension);
  CHECK(law.failure({.points = {slid, slid}, .states = {{{1}, {1}}}}) == BondFailure::shear);
}

TEST_CASE("parameters that break a rule are named") {
  CHECK(message_of([] { SofteningBond{.fracture_energy = 100}.validate(); }) ==
        "SofteningBond.fracture_energy = 100: must be above tensile_strength^2 / (2 "
        "normal_stiffness)");
  CHECK(message_of([] { SofteningBond{.fracture_energy = 500}.validate(); }) ==
        "SofteningBond.fracture_energy = 500: must be above shear_strength^2 / (2 "
        "tangential_stiffness)");
  CHECK(message_of([] { SofteningBond{.tensile_strength = 0}.validate(); }) != "");
  CHECK(message_of([] { SofteningBond{}.validate(); }) == "");
}
