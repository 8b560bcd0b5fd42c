// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Lets Boost.Geometry see riprap's points and polygons in place, without a copy.
/// Includes only Boost.Geometry's core traits; include the algorithms you use yourself.

#include <boost/geometry/core/access.hpp>
#include <boost/geometry/core/closure.hpp>
#include <boost/geometry/core/coordinate_dimension.hpp>
#include <boost/geometry/core/coordinate_system.hpp>
#include <boost/geometry/core/coordinate_type.hpp>
#include <boost/geometry/core/cs.hpp>
#include <boost/geometry/core/point_order.hpp>
#include <boost/geometry/core/tag.hpp>
#include <boost/geometry/core/tags.hpp>
#include <boost/mpl/int.hpp>
#include <cstddef>

#include <riprap/core/vec2.hpp>
#include <riprap/geometry/convex_polygon.hpp>

namespace boost::geometry::traits {

template <>
struct tag<riprap::Vec2> {
  using type = point_tag;
};
template <>
struct coordinate_type<riprap::Vec2> {
  using type = double;
};
template <>
struct coordinate_system<riprap::Vec2> {
  using type = cs::cartesian;
};
template <>
struct dimension<riprap::Vec2> : mpl::int_<2> {};  // std::integral_constant: not in Boost 1.74

template <std::size_t Axis>
struct access<riprap::Vec2, Axis> {
  static double get(const riprap::Vec2& v) { return v[Axis]; }
  static void set(riprap::Vec2& v, double value) { v[Axis] = value; }
};

template <>
struct tag<riprap::ConvexPolygon> {
  using type = ring_tag;
};
template <>
struct point_order<riprap::ConvexPolygon> {
  static constexpr order_selector value = counterclockwise;
};
template <>
struct closure<riprap::ConvexPolygon> {
  static constexpr closure_selector value = open;
};

}  // namespace boost::geometry::traits
