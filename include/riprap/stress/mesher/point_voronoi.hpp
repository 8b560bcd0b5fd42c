// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The Voronoi diagram of points by Boost.Polygon, without its code for segments.

#include <boost/polygon/voronoi_builder.hpp>
#include <boost/polygon/voronoi_diagram.hpp>
#include <cstdint>

#include <riprap/core/compiler.hpp>

namespace riprap {

namespace internal {

using VoronoiTraits = boost::polygon::detail::voronoi_ctype_traits<std::int32_t>;

// The predicates of Boost.Polygon, but for circles that a segment touches: they are never asked
// for, and are 40 kB of code for every program to compile.
struct PointPredicates : boost::polygon::detail::voronoi_predicates<VoronoiTraits> {
  template <class Site, class Circle>
  class circle_formation_predicate {
   public:
    // Whether three points make a circle that the sweep will meet, and which.
    bool operator()(const Site& a, const Site& b, const Site& c, Circle& circle) {
      if (!exists_.ppp(a, b, c)) return false;
      form_.ppp(a, b, c, circle);
      return true;
    }

   private:
    circle_existence_predicate<Site> exists_;
    lazy_circle_formation_functor<Site, Circle> form_;
  };
};

}  // namespace internal

/// Takes points by `insert_point(x, y)` and writes their diagram by `construct(&diagram)`.
using PointVoronoiBuilder = boost::polygon::voronoi_builder<std::int32_t, internal::VoronoiTraits,
                                                            internal::PointPredicates>;

/// Cells, edges and vertices; a cell's `source_index` is the number of its point.
using PointVoronoi = boost::polygon::voronoi_diagram<double>;

}  // namespace riprap
