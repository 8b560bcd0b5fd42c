// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The line from point to point of the two largest opposed contact forces.

#include <riprap/breakage/failure/opposed_forces.hpp>
#include <riprap/breakage/line_fit/concepts.hpp>

namespace riprap {

/// Along it a disc splits in a Brazilian test, and a block in Cundall and Hart (1985). No line
/// where no two forces push against each other.
struct LoadedDiameter {
  [[nodiscard]] std::optional<Line> operator()(const LoadedParticle& particle) const {
    const std::optional<OpposedForces> pair = largest_opposed_forces(particle);
    if (!pair) return std::nullopt;
    return Line{0.5 * (pair->from + pair->to), (pair->to - pair->from) / pair->distance};
  }
};

static_assert(LoadLineFit<LoadedDiameter>);

}  // namespace riprap
