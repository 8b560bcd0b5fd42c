// SPDX-License-Identifier: BSL-1.0
// riprap: a BondLaw must have double peak_stiffness() const
#include <riprap/bond/bond_law/brittle_bond.hpp>
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine : BrittleBond {
  double peak_stiffness() { return 1e9; }
};

const auto model = Model{}.bond_law(Mine{});
