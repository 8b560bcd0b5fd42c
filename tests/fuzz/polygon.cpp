// SPDX-License-Identifier: BSL-1.0
// Any vertices make a polygon that keeps its rules, or are refused with InvalidInput.

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <riprap/geometry/polygon_properties.hpp>

#include "check.hpp"
#include "shapes.hpp"
#include "targets.hpp"

namespace riprap::fuzz {

namespace {

/// Smallest distance of a vertex to the left of an edge, over the diameter, in more digits than the
/// library's; and the length of the shortest edge likewise.
long double least_share(Ring ring) {
  using Wide = long double;
  const auto difference = [&](std::size_t from, std::size_t to, int axis) {
    return static_cast<Wide>(ring[to][axis]) - static_cast<Wide>(ring[from][axis]);
  };
  const std::size_t n = ring.size();
  Wide least = std::numeric_limits<Wide>::infinity();
  Wide squared = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    const Wide x = difference(i, next, 0);
    const Wide y = difference(i, next, 1);
    const Wide length = std::sqrt(x * x + y * y);
    least = std::min(least, length);
    for (std::size_t k = 0; k < n; ++k) {
      const Wide kx = difference(i, k, 0);
      const Wide ky = difference(i, k, 1);
      squared = std::max(squared, kx * kx + ky * ky);
      if (k != i && k != next && length > 0) least = std::min(least, (x * ky - y * kx) / length);
    }
  }
  return least / std::sqrt(squared);
}

void check_properties(const ConvexPolygon& polygon) {
  const Ring ring = polygon.ring();
  const AreaProperties p = area_properties(ring);
  const double size = diameter(ring);
  check(std::isfinite(p.area) && p.area > 0, "a polygon has an area above 0", {p.area});
  check(p.area == polygon_area(ring), "both ways to compute an area agree to the last bit");
  const auto exact = static_cast<double>(exact_area(ring));
  check(std::abs(p.area - exact) <= 1e-6 * exact, "the area of a polygon has six digits", {p.area});
  check(std::isfinite(p.polar_moment) && p.polar_moment > 0, "a polygon has a polar moment above 0",
        {p.polar_moment});
  const double round_off = 1e-15 * largest_coordinate(ring) + 1e-6 * size;
  for (int axis = 0; axis < 2; ++axis) {
    const auto [low, high] =
        std::ranges::minmax(ring, {}, [axis](const Vec2& v) { return v[axis]; });
    check(p.centroid[axis] >= low[axis] - round_off && p.centroid[axis] <= high[axis] + round_off,
          "the centroid lies within the extent of the polygon", {p.centroid.x(), p.centroid.y()});
  }
  const double width = least_width(ring);
  check(width > 0 && width <= size * (1 + 1e-12), "the least width lies between 0 and the diameter",
        {width, size});
  check(std::isfinite(aspect(ring)), "the aspect of a polygon is finite", {aspect(ring)});
  check(std::isfinite(equivalent_diameter(p.area)), "the equivalent diameter is finite");
}

void check_same_rule(const ConvexPolygon& polygon, long double margin, Input& input) {
  std::vector<Vec2> begun(polygon.begin(), polygon.end());
  std::rotate(begun.begin(), begun.begin() + input.below(static_cast<unsigned>(begun.size())),
              begun.end());
  check(try_convex_polygon(begun).has_value(), "a polygon may begin at any of its vertices");
  std::reverse(begun.begin(), begun.end());
  check(!try_convex_polygon(begun), "a clockwise ring is refused");

  const ConvexPolygon same = polygon.moved({}, {0, 0});
  check(std::ranges::equal(same, polygon), "a polygon that is moved by nothing is the same");
  // Further away and turned, the last digits of coordinates are others.
  const double far = largest_coordinate(polygon.ring());
  const Rotation turn = turn_from(input);
  const Vec2 shift = far * Vec2{2 * input.share() - 1, 2 * input.share() - 1};
  if (margin < 2e-9L || far > 1e3 * diameter(polygon.ring())) return;
  check_properties(polygon.moved(turn, shift));
}

}  // namespace

void polygon(Bytes bytes) {
  Input input(bytes);
  std::vector<Vec2> vertices;
  if (input.yes()) {
    for (unsigned n = input.below(70); n > 0; --n)
      vertices.push_back(input.yes() ? Vec2{input.any(), input.any()}
                                     : Vec2{input.number(), input.number()});
  } else {
    vertices = ring_from(input);
    if (!vertices.empty() && input.below(4) == 0)
      vertices[input.below(static_cast<unsigned>(vertices.size()))] = {input.number(), input.any()};
  }
  std::optional<ConvexPolygon> accepted;
  try {
    accepted = ConvexPolygon(vertices);
  } catch (const InvalidInput&) {
    check(!try_convex_polygon(vertices), "try_convex_polygon accepts what the constructor refuses");
    const bool plain = vertices.size() >= 3 && vertices.size() <= max_polygon_vertices &&
                       std::ranges::all_of(vertices, is_finite);
    if (!plain || largest_coordinate(vertices) > 1e60 || diameter(vertices) < 1e-60) return;
    check(!(least_share(vertices) > 1.001e-9L),
          "a ring that is convex by more than a billionth of its diameter is refused");
    return;
  }
  check(try_convex_polygon(vertices).has_value(),
        "try_convex_polygon refuses what the constructor accepts");
  check(std::ranges::equal(*accepted, vertices), "a polygon has the vertices that it was given");
  const long double margin = least_share(vertices);
  check(margin > 0.999e-9L, "a ring that is not convex by a billionth of its diameter is accepted",
        {static_cast<double>(margin)});
  check_properties(*accepted);
  check_same_rule(*accepted, margin, input);
}

}  // namespace riprap::fuzz
