// SPDX-License-Identifier: BSL-1.0
// riprap: a BondLaw must have double stored_energy(const BondDisplacement&, const State&) const
#include <riprap/bond/bond_law/brittle_bond.hpp>
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine : BrittleBond {
  double stored_energy = 0;
};

const auto model = Model{}.bond_law(Mine{});
