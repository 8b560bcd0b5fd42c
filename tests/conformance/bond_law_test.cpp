// SPDX-License-Identifier: BSL-1.0
#include <riprap/conformance/bond_law.hpp>

#include <doctest/doctest.h>

#include <riprap/bond/bond_law/brittle_bond.hpp>
#include <riprap/bond/bond_law/no_bonds.hpp>
#include <riprap/bond/bond_law/softening_bond.hpp>
#include <support/violated.hpp>

using namespace riprap;
using test::check_violated;

namespace {

struct Spring {
  struct State {};
  double stiffness = 1e11;
  BondTraction operator()(const BondDisplacement& d, State&) const {
    return {.normal = -stiffness * d.opening, .tangential = -stiffness * d.sliding};
  }
  double stored_energy(const BondDisplacement& d, const State&) const {
    return 0.5 * stiffness * (d.opening * d.opening + d.sliding * d.sliding);
  }
  BondFailure failure(const BondView<State>&) const { return BondFailure::none; }
  double peak_stiffness() const { return stiffness; }
};
struct Prestressed : Spring {
  BondTraction operator()(const BondDisplacement& d, State&) const {
    return {.normal = -stiffness * d.opening - 1e3, .tangential = -stiffness * d.sliding};
  }
};
struct TwiceTheEnergy : Spring {
  double stored_energy(const BondDisplacement& d, const State& s) const {
    return 2 * Spring::stored_energy(d, s);
  }
};
struct Soft : Spring {
  double peak_stiffness() const { return 0.5 * stiffness; }
};
struct Broken : Spring {
  BondFailure failure(const BondView<State>&) const { return BondFailure::shear; }
};
struct WearsOut : Spring {  // at every call
  struct State {
    double left = 1;
  };
  BondTraction operator()(const BondDisplacement& d, State& s) const {
    s.left *= 0.999;
    return {.normal = -s.left * stiffness * d.opening, .tangential = 0};
  }
  double stored_energy(const BondDisplacement& d, const State& s) const {
    return 0.5 * s.left * stiffness * d.opening * d.opening;
  }
  BondFailure failure(const BondView<State>&) const { return BondFailure::none; }
};
struct OneSided : Spring {
  BondTraction operator()(const BondDisplacement& d, State&) const {
    return {.normal = -stiffness * d.opening,
            .tangential = d.sliding > 0 ? -stiffness * d.sliding : 0};
  }
};

}  // namespace

TEST_CASE("the bond laws of riprap obey the axioms") {
  CHECK(to_text(bond_law_violations(NoBonds{})) == "");
  CHECK(to_text(bond_law_violations(BrittleBond{})) == "");
  CHECK(to_text(bond_law_violations(SofteningBond{})) == "");
  CHECK(to_text(bond_law_violations(SofteningBond{}, {.largest = 1e-3})) == "");
  CHECK(to_text(bond_law_violations(Spring{})) == "");
}

TEST_CASE("what breaks an axiom of bond laws is reported") {
  check_violated(bond_law_violations(Prestressed{}), "no displacement, no normal traction");
  check_violated(bond_law_violations(TwiceTheEnergy{}),
                 "the normal traction is minus the gradient of the energy");
  check_violated(bond_law_violations(TwiceTheEnergy{}),
                 "work done on a bond is stored or lost: the rest [J/m^2]");
  check_violated(bond_law_violations(Soft{}),
                 "the normal traction is at most the peak stiffness times the opening");
  check_violated(bond_law_violations(Broken{}), "a new bond holds");
  check_violated(bond_law_violations(WearsOut{}), "evaluated again, the normal traction stays");
  check_violated(bond_law_violations(OneSided{}), "mirrored displacements give mirrored tractions");
}
