// SPDX-License-Identifier: BSL-1.0
// A polygon cut by any line, and its pieces cut again, by `cut` and by StraightCut.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include <riprap/breakage/splitter/straight_cut.hpp>
#include <riprap/geometry/cut.hpp>

#include "check.hpp"
#include "shapes.hpp"
#include "targets.hpp"

namespace riprap::fuzz {

namespace {

/// Through a corner or the middle of two, along an edge, beside one of these by a little, or
/// anywhere.
Line line_from(Ring ring, Input& input) {
  const unsigned kind = input.byte();
  if (kind >= 252) return {{input.any(), input.any()}, {input.any(), input.any()}};
  const auto vertex = [&]() -> const Vec2& {
    return ring[input.below(static_cast<unsigned>(ring.size()))];
  };
  const double size = diameter(ring);
  Vec2 point = vertex();
  if ((kind & 1U) != 0) point = 0.5 * (point + vertex());
  const Vec2 across = vertex() - point;
  Vec2 direction = turn_from(input) * Vec2{1, 0};
  if (const double length = across.norm(); (kind & 2U) == 0 && length > 0)
    direction = across / length;
  if ((kind & 4U) != 0) point += size * Vec2{input.tiny(), input.tiny()};
  if ((kind & 8U) != 0) direction = Rotation::from_angle(input.tiny()) * direction;
  if ((kind & 16U) != 0) point += size * (2 * input.share() - 1) * direction;
  if ((kind & 32U) != 0) point += size * (2 * input.share() - 1) * perpendicular(direction);
  return {point, direction};
}

void check_pieces(Ring ring, const Line& line, double snap, const CutRings& parts) {
  const long double area = exact_area(ring);
  const double size = diameter(ring);
  // The last term is the round-off of this sum.
  const long double error = exact_area(parts.left) + exact_area(parts.right) - area;
  check(std::abs(error) <= 1e-12L * area + 1e-18L * static_cast<long double>(size * size),
        "the areas of the pieces add up to that of the ring", {static_cast<double>(error / area)});
  check(parts.left.size() >= 3 && parts.right.size() >= 3, "a piece has three vertices or more");

  std::size_t shared = 0;
  for (const Vec2& v : parts.left)
    shared += static_cast<std::size_t>(std::count(parts.right.begin(), parts.right.end(), v));
  check(shared == 2, "the pieces share both ends of the cut and no other vertex",
        {static_cast<double>(shared)});
  std::size_t kept = 0;
  for (const Vec2& v : ring) {
    const auto left = std::count(parts.left.begin(), parts.left.end(), v);
    const auto right = std::count(parts.right.begin(), parts.right.end(), v);
    check(left <= 1 && right <= 1 && left + right >= 1,
          "every vertex of the ring is a vertex of one piece, or an end of the cut",
          {v.x(), v.y()});
    kept += static_cast<std::size_t>(left + right);
  }
  check(parts.left.size() + parts.right.size() - kept <= 4, "a cut makes two vertices at most");

  if (!(std::abs(line.direction.norm() - 1) < 1e-9)) return;  // no unit vector, so no distances
  const double beyond = std::max(snap, 1e-6) * size + 1e-14 * (size + largest_coordinate(ring));
  for (const Vec2& v : parts.left)
    check(line.left_distance(v) >= -beyond, "the left piece lies on the left",
          {line.left_distance(v), beyond});
  for (const Vec2& v : parts.right)
    check(line.left_distance(v) <= beyond, "the right piece lies on the right",
          {line.left_distance(v), beyond});
}

void check_straight_cut(Ring ring, const Line& line, Input& input) {
  StraightCut splitter;
  if (input.yes()) {
    splitter.minimum_area = 0;
    splitter.maximum_aspect = std::numeric_limits<double>::infinity();
  }
  splitter.validate();
  const double mean_area = polygon_area(ring) * std::ldexp(1, static_cast<int>(input.below(8)) - 4);
  const std::optional<CutRings> parts = splitter(ring, line, mean_area);
  if (!parts) return;
  check_pieces(ring, line, 1e-3, *parts);
  for (const std::vector<Vec2>& piece : {parts->left, parts->right}) {
    check(try_convex_polygon(piece).has_value(), "a piece of StraightCut is a polygon");
    check(polygon_area(piece) >= splitter.minimum_area * mean_area,
          "a piece of StraightCut has the least area");
    check(aspect(piece) <= splitter.maximum_aspect, "a piece of StraightCut is not too slender");
  }
}

}  // namespace

void cut(Bytes bytes) {
  Input input(bytes);
  const std::optional<ConvexPolygon> whole = polygon_from(input);
  if (!whole) return;
  std::vector<std::vector<Vec2>> rings{{whole->begin(), whole->end()}};
  for (int step = 0; step < 12 && !input.empty(); ++step) {
    const std::vector<Vec2> ring = rings[input.below(static_cast<unsigned>(rings.size()))];
    const Line line = line_from(ring, input);
    check_straight_cut(ring, line, input);
    const double snap = input.yes() ? 1e-6 : std::min(std::abs(input.tiny()), 0.01);
    const std::optional<CutRings> parts = riprap::cut(ring, line, snap);
    if (!parts) continue;
    check_pieces(ring, line, snap, *parts);
    for (const std::vector<Vec2>& piece : {parts->left, parts->right})
      if (try_convex_polygon(piece)) rings.push_back(piece);
  }
}

}  // namespace riprap::fuzz
