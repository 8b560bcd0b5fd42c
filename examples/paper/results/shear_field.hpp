// SPDX-License-Identifier: BSL-1.0
#pragma once
// The shear around every particle over a stretch of strain, and how the places with the most of it
// lie to each other: shear bands by their direction.

#include <vector>

#include <riprap/core/vec2.hpp>

namespace report {

struct ShearedParticle {
  riprap::Vec2 place{0, 0};       // from the centre, over the radius of the unsheared sample
  riprap::Vec2 unstrained{0, 0};  // the same without the strain so far
  double shear = 0;               // largest shear strain around it [-]
};

// What BandRecord has left of one stretch; places are those at its beginning.
struct ShearWindow {
  double axial_strain = 0;  // at its end
  std::vector<ShearedParticle> particles;
};

// Mean distance from the centre over the radius, without strain, of the tenth of the particles with
// the most shear around them. Not a number without particles.
double radius_of_bands(const ShearWindow& window);

// Pairs within a tenth of the particles with the most shear that lie `nearest` to `farthest` mean
// spacings apart: the share of them whose direction lies within 22.5 degrees of 54 degrees to axis
// 1, on either side, less the same share of all pairs of particles. Zero by chance whatever the
// outline of the sample; one half where all lie in bands between 45 degrees + half the dilation
// angle (Roscoe) and 45 degrees + half the friction angle (Coulomb), about 45 to 63 degrees. Not a
// number without such pairs.
double band_direction_excess(const ShearWindow& window, double nearest = 2, double farthest = 8);

}  // namespace report
