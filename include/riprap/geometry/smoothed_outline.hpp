// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// An outline with smaller steps of its pixels. Optional: not part of riprap.hpp.

#include <riprap/core/linkage.hpp>
#include <riprap/geometry/outline.hpp>

namespace riprap {

/// Local least-squares parabolas of both coordinates over the arc length, up to `half_width` [m]
/// before and after a point (A. Savitzky and M. J. E. Golay, Anal. Chem. 36, 1964), at points an
/// eighth of it apart. Of a wave with a length of 0.25 to 1.4 half widths a quarter or less stays,
/// 0.35 at 1.5, 0.72 at 2, 0.93 at 3; a circle of radius r shrinks by a share of
/// (half_width / r)^4 / 230. A second pass squares what stays and doubles that share.
///
/// Steps of a contour that follows pixels are half a pixel to both sides. With 8 pixels up to 0.3
/// pixels of them stay, with or without a second pass, where an edge is at 5 to 43 degrees to an
/// axis, and up to all of them nearer to an axis or to a diagonal, where steps are longer.
///
/// Throws InvalidInput unless `half_width` is above 0 and at most a quarter of the perimeter, and
/// where the smoothed ring crosses itself.
[[nodiscard]] Outline smoothed_outline(const Outline& outline, double half_width);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/geometry/smoothed_outline.ipp>
#endif
