// SPDX-License-Identifier: BSL-1.0
// riprap: a BondLaw must have BondFailure failure(const BondView<State>&) const
#include <riprap/bond/bond_law/brittle_bond.hpp>
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine : BrittleBond {
  bool failure(const BondView<State>&) const { return false; }
};

const auto model = Model{}.bond_law(Mine{});
