// SPDX-License-Identifier: BSL-1.0
// Particles of bonded cells: Kun and Herrmann (1996), Seyedi Hosseininia and Mirghasemi (2006).

#include <riprap/breakage/criterion/never_fails.hpp>
#include <riprap/particle/bonded_cells.hpp>

#include "../bonded_disc/disc_strength.hpp"
#include "run_model.hpp"

rivals::Json rivals::run_bonded(const Case& c) {
  Case cut = c;
  cut.sample = riprap::bonded_cells(c.sample, {.count = c.cells, .seed = c.seed << 32});
  const riprap::BrittleBond bond = bonded_disc::calibrated_bond(
      {.diameter = c.diameter, .thickness = c.sample.thickness, .cells = c.cells}, c.strength);
  Json j = run_model(riprap::Model{}.criterion(riprap::NeverFails{}).bond_law(bond), cut);
  j["tensile_strength_of_bonds_Pa"] = bond.tensile_strength;
  return j;
}
