// SPDX-License-Identifier: BSL-1.0
// riprap: a BondLaw must have BondTraction operator()(const BondDisplacement&, State&) const
#include <riprap/bond/bond_law/brittle_bond.hpp>
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine : BrittleBond {
  double operator()(const BondDisplacement& d, State&) const { return -1e9 * d.opening; }
};

const auto model = Model{}.bond_law(Mine{});
