// SPDX-License-Identifier: BSL-1.0
#pragma once
// The Brazilian strength of a disc of bonded cells.

#include <riprap/bond/bond_law/brittle_bond.hpp>

namespace bonded_disc {

struct BondedDisc {
  double stiffness = 2e12;   // of the bonds, normal and tangential [Pa/m]
  double diameter = 0.016;   // [m]
  double thickness = 0.016;  // [m]
  unsigned cells = 12;
  unsigned discs = 16;  // of different cells
  double speed = 0.02;  // of each plate [m/s]
};

// 2 F / (pi D t) [Pa] with the force F at which the disc fails between two plates, where it falls
// by a tenth; the mean over the discs.
double brazilian_strength(const BondedDisc& disc, const riprap::BrittleBond& bond);

// A bond of the stiffness of the disc's, with the strengths at which the discs have a strength
// [Pa]. The two are nearly proportional: four corrections are enough for 1 %.
riprap::BrittleBond calibrated_bond(const BondedDisc& disc, double strength);

}  // namespace bonded_disc
