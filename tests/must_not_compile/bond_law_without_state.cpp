// SPDX-License-Identifier: BSL-1.0
// riprap: a BondLaw must have a type State that can be default-constructed and copied
#include <riprap/bond/bond_law/brittle_bond.hpp>
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine : BrittleBond {
  struct State {
    explicit State(int) {}
  };
};

const auto model = Model{}.bond_law(Mine{});
