// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A convex polygon as Voronoi cells. Optional: not part of riprap.hpp.

#include <cstdint>
#include <vector>

#include <riprap/core/linkage.hpp>
#include <riprap/geometry/convex_polygon.hpp>

namespace riprap {

/// What Voronoi cells are made of: random points, spread evenly, then moved to the centroids of
/// their cells again and again (S. P. Lloyd: Least squares quantization in PCM, IEEE Trans. Inf.
/// Theory 28, 1982). F. Kun and H. J. Herrmann (Comput. Methods Appl. Mech. Eng. 138, 1996) make
/// cells regular by one random point in each field of a square lattice instead.
struct VoronoiPoints {
  unsigned count = 50;       ///< of cells, 1 to 20,000
  unsigned relaxations = 4;  ///< of Lloyd; 0: uneven cells, 20: nearly hexagons
  std::uint64_t seed = 1;

  /// Throws InvalidInput that names the value and the rule.
  void validate() const;
};

/// Number of cells of a mean equivalent diameter [m] in an area [m^2], 1 or more.
[[nodiscard]] unsigned count_of_cells(double area, double mean_diameter);

/// Voronoi cells that fill a polygon, in the order of their points. Common vertices have the same
/// bits in all cells, cells meet along whole edges, and areas add up to the polygon's to round-off.
/// No edge is shorter than 1e-5 of the cells' size: ends nearer than that become one vertex. Same
/// seed, same bytes. Throws InvalidInput for options that break a rule, and for a polygon too thin
/// for its cells to be convex polygons. The cost is of the order of the square of the count: half a
/// second for 1,000 cells, some ten for 5,000.
[[nodiscard]] std::vector<ConvexPolygon> voronoi_cells(const ConvexPolygon& polygon,
                                                       const VoronoiPoints& options = {});

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/geometry/voronoi_cells.ipp>
#endif
