// SPDX-License-Identifier: BSL-1.0
#pragma once
// Where shear localises: the shear strain around each particle, from what it and its neighbours
// moved.

#include <vector>

#include <riprap/experiment/incremental_displacement.hpp>

namespace study {

// A free particle of an assembly, where it would be without the strain so far.
struct Sheared {
  riprap::Vec2 place{0, 0};  // [m] from the centre
  double shear = 0;          // largest shear strain around it [-]
};

// Of every free particle: the maximum shear of the displacement gradient that fits its own movement
// and that of its twelve nearest best. `stretch` is that of the sample when the moves began.
std::vector<Sheared> shear_around(const std::vector<riprap::Move>& moves,
                                  const riprap::Vec2& stretch);

// Share of the particles with less shear than the one nearest to a place; one half by chance.
// Throws InvalidInput if there are no particles.
double band_share(const std::vector<Sheared>& all, const riprap::Vec2& place);

}  // namespace study
