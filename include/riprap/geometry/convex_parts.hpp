// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A concave outline as convex parts. Optional: not part of riprap.hpp.

#include <vector>

#include <riprap/core/linkage.hpp>
#include <riprap/geometry/convex_polygon.hpp>
#include <riprap/geometry/outline.hpp>
#include <riprap/geometry/triangle_indices.hpp>

namespace riprap {

/// Triangles of an outline by its own vertices, counter-clockwise, places in its ring: its
/// constrained Delaunay triangulation, in which no triangle can be made less sharp by exchanging
/// the diagonal of two. n vertices have n - 2 triangles. Throws InvalidInput for an outline so thin
/// that round-off leaves none. The cost is of the order of n^2.
[[nodiscard]] std::vector<TriangleIndices> triangulate(const Outline& outline);

/// Convex parts that fill an outline: the triangles of `triangulate`, joined across every diagonal
/// that is not needed, the longest first (S. Hertel, K. Mehlhorn: Fast triangulation of simple
/// polygons, LNCS 158, 1983). At most four times as many as the fewest that are possible, and at
/// most 2 r + 1 for r corners of more than 180 degrees; not always the fewest. A convex outline is
/// one part. A part of more vertices than a ConvexPolygon may have is cut again. Vertices are those
/// of the outline, the same bits in all parts, and parts meet along whole edges: a part has no
/// vertex within an edge of another. Throws InvalidInput as `triangulate` does, and for a part
/// thinner than a ConvexPolygon may be.
[[nodiscard]] std::vector<ConvexPolygon> convex_parts(const Outline& outline);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/geometry/convex_parts.ipp>
#endif
