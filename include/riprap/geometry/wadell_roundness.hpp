// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Roundness of H. Wadell (J. Geol. 40, 1932) of a digitised outline. Optional: not part of
/// riprap.hpp.

#include <vector>

#include <riprap/core/linkage.hpp>
#include <riprap/geometry/circles.hpp>
#include <riprap/geometry/outline.hpp>

namespace riprap {

/// How closely circles follow an outline. The program of J. Zheng and R. D. Hryciw has 0.3 pixels
/// for any size and 0.98; in proportion to the largest circle inside, 0.3 pixels of a radius of
/// 100, the deviation is this library's.
struct CornerFit {
  double deviation = 0.003;  ///< of the outline from lines between key points, over that radius
  double closeness = 0.98;   ///< of distances from the centre to the circle's radius, at least

  /// Throws InvalidInput unless both lie in (0, 1).
  void validate() const;
};

struct OutlineCorners {
  Circle inside;                ///< the largest circle inside, to 1e-4 of its radius
  std::vector<Circle> corners;  ///< none larger than it; sharp ones have the radius 0
};

/// The circles of convex corners (J. Zheng, R. D. Hryciw: Traditional soil particle sphericity,
/// roundness and surface roughness by computational geometry, Geotechnique 65, 2015). Key points
/// divide the outline into stretches that are straight to `deviation`. A corner is three or more of
/// them in a row at which the outline turns left, with all points between; its circle is that of
/// least squares, if
/// - it is not larger than the largest one inside,
/// - no edge of the outline lies deeper in it than `closeness` allows, and no point of the corner
///   as far out of it.
/// Corners are taken in falling order of the angle by which the outline turns, where the paper goes
/// round from a start. A key point outside all corners at which the outline turns by more than an
/// edge of a circle may, 2 acos(closeness), 23 degrees, is a sharp corner: a corner that no circle
/// fits counts once for each such point, or not at all. The paper fits circles to key points alone.
///
/// So a corner needs edges that turn by less than 23 degrees each, and a radius above some 0.02 of
/// the largest circle's; a polygon with few vertices is sharp. Where corners are less than four
/// tenths of their radius apart, a circle may take in a part of the next; where the curvature
/// varies, as at the end of an ellipse, its radius exceeds the least one by a share of the order of
/// sqrt(1 - closeness). Roughness above the deviation makes corners of its own, or divides one:
/// smooth it first (smoothed_outline.hpp), which leaves some (docs/shapes.md). Throws InvalidInput
/// for a fit that breaks a rule, and for an outline in which it finds no corner.
[[nodiscard]] OutlineCorners outline_corners(const Outline& outline, const CornerFit& fit = {});

/// Mean radius of the corners over that of the largest circle inside [-]: 1 of a circle, r / R of a
/// rounded polygon, 0 of a sharp one. With the limits and errors of `outline_corners`.
[[nodiscard]] double wadell_roundness(const Outline& outline, const CornerFit& fit = {});

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/geometry/wadell_roundness.ipp>
#endif
