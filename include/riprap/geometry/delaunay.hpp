// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Delaunay triangulation of points. Optional: not part of riprap.hpp.

#include <span>
#include <vector>

#include <riprap/core/linkage.hpp>
#include <riprap/core/vec2.hpp>
#include <riprap/geometry/triangle_indices.hpp>

namespace riprap {

/// Triangles of points [m], from the Voronoi diagram of Boost.Polygon, which is exact for integers:
/// points are rounded to 2^-30 of their extent. Of points on one circle any triangulation will do,
/// and of those that round to one only one is in it. Triangles whose unrounded points are not
/// counter-clockwise, far thinner than any others, are left out. Empty for fewer than three points
/// and for points on a line. Throws InvalidInput for a point that is not finite.
[[nodiscard]] std::vector<TriangleIndices> delaunay(std::span<const Vec2> points);

/// The triangulation without flat triangles at its edge: those whose height over their side on the
/// edge is below `least_height` of that side, taken off until none is left. Points on a nearly
/// straight edge are joined by such triangles, which say nothing of what lies between the points.
/// Throws InvalidInput unless `least_height` [-] is 0 or above.
[[nodiscard]] std::vector<TriangleIndices> without_flat_edge(std::vector<TriangleIndices> triangles,
                                                             std::span<const Vec2> points,
                                                             double least_height);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/geometry/delaunay.ipp>
#endif
