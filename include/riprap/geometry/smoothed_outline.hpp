// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// An outline without the steps of its pixels. Optional: not part of riprap.hpp.

#include <riprap/core/linkage.hpp>
#include <riprap/geometry/outline.hpp>

namespace riprap {

/// Local least-squares parabolas of both coordinates over the arc length, up to `half_width` [m]
/// before and after a point (A. Savitzky and M. J. E. Golay, Anal. Chem. 36, 1964), at points an
/// eighth of it apart. What is shorter than the width goes; a circle of radius r shrinks by a share
/// of (half_width / r)^4 / 230. Some 8 pixels remove the steps of a contour that follows pixels.
/// Throws InvalidInput unless `half_width` is above 0 and at most a quarter of the perimeter, and
/// where the smoothed ring crosses itself.
[[nodiscard]] Outline smoothed_outline(const Outline& outline, double half_width);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/geometry/smoothed_outline.ipp>
#endif
