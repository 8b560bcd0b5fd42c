// SPDX-License-Identifier: BSL-1.0
#include <riprap/geometry/wadell_roundness.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <riprap/geometry/line_side.hpp>
#include <riprap/geometry/smoothed_outline.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>
#include <support/polygons.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

/// A ring with corners rounded to these radii, 0 for sharp, each arc of so many edges.
std::vector<Vec2> rounded(const std::vector<Vec2>& ring, const std::vector<double>& radii,
                          int edges) {
  std::vector<Vec2> out;
  const std::size_t n = ring.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Vec2 before = (ring[k] - ring[previous_vertex(k, n)]).normalized();
    const Vec2 after = (ring[next_vertex(k, n)] - ring[k]).normalized();
    const double turn = std::atan2(cross(before, after), before.dot(after));
    const double side = turn > 0 ? radii[k] : -radii[k];
    const Vec2 start = ring[k] - side * std::tan(turn / 2) * before;
    const Vec2 centre = start + side * perpendicular(before);
    for (int i = 0; i <= (radii[k] > 0 ? edges : 0); ++i)
      out.push_back(centre + Rotation::from_angle(turn * i / edges) * Vec2(start - centre));
  }
  return out;
}

std::vector<Vec2> rounded(const std::vector<Vec2>& ring, double radius, int edges = 16) {
  return rounded(ring, std::vector<double>(ring.size(), radius), edges);
}

std::vector<Vec2> ellipse(double a, double b, int n) {
  std::vector<Vec2> out;
  for (int k = 0; k < n; ++k)
    out.push_back({a * std::cos(2 * pi * k / n), b * std::sin(2 * pi * k / n)});
  return out;
}

/// The contour of a ring in pixels of a size: the nearest centres of pixels along it.
std::vector<Vec2> in_pixels(const std::vector<Vec2>& ring, double size) {
  std::vector<Vec2> out;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Vec2 edge = ring[next_vertex(k, ring.size())] - ring[k];
    const int steps = static_cast<int>(std::ceil(4 * edge.norm() / size));
    for (int i = 0; i < steps; ++i) {
      const Vec2 p = (ring[k] + (static_cast<double>(i) / steps) * edge) / size;
      const Vec2 pixel = size * Vec2{std::round(p.x()), std::round(p.y())};
      if (out.empty() || pixel != out.back()) out.push_back(pixel);
    }
  }
  return out;
}

/// As docs/shapes.md has it, with 0.5 of so many pixels.
Outline smoothed_twice(const std::vector<Vec2>& contour, double pixels) {
  const double half_width = 8 * 0.5 / pixels;
  return smoothed_outline(smoothed_outline(Outline(contour), half_width), half_width);
}

std::vector<Vec2> turned(std::vector<Vec2> ring, double angle) {
  for (Vec2& v : ring) v = Rotation::from_angle(angle) * v;
  return ring;
}

const std::vector<Vec2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
const std::vector<Vec2> slab{{0, 0}, {2, 0}, {2, 1}, {0, 1}};
const std::vector<Vec2> triangle{{0, 0}, {1, 0}, {0.5, std::sqrt(0.75)}};
const std::vector<Vec2> l_shape{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};

/// Points of an arc lie on it: its radius is exact, and that of the largest circle too small by a
/// share of 1e-4 at most.
Near to_circle_inside(double expected) { return near(expected * (1 + 5e-5), 5.1e-5 * expected); }

}  // namespace

TEST_CASE("rounded squares, rectangles and triangles have r / R") {
  const double in_triangle = std::sqrt(3) / 6;
  for (const double r : {0.02, 0.07, 0.2}) {
    CHECK(wadell_roundness(Outline(rounded(square, r))) == to_circle_inside(r / 0.5));
    CHECK(wadell_roundness(Outline(rounded(slab, r))) == to_circle_inside(r / 0.5));
    CHECK(wadell_roundness(Outline(rounded(triangle, r))) == to_circle_inside(r / in_triangle));
  }
  CHECK(wadell_roundness(Outline(rounded(square, 0.4))) == to_circle_inside(0.8));
  CHECK(wadell_roundness(Outline(rounded(slab, 0.5))) == to_circle_inside(1));
}

TEST_CASE("rotation, size, place, start and orientation do not matter") {
  const std::vector<double> radii{0.1, 0.2, 0.05, 0};
  const std::vector<Vec2> ring = rounded(square, radii, 16);
  const Near expected = to_circle_inside(0.35 / 4 / 0.5);
  for (const Pose& pose : poses(1))
    for (const double size : {1e-3, 1.0}) {
      std::vector<Vec2> moved;
      for (const Vec2& v : ring) moved.push_back(size * pose.of(v));
      for (std::size_t start = 0; start < moved.size(); start += 5) {
        std::rotate(moved.begin(), moved.begin() + 5, moved.end());
        CHECK(wadell_roundness(Outline(moved)) == expected);
      }
      std::reverse(moved.begin(), moved.end());
      CHECK(wadell_roundness(Outline(moved)) == expected);
    }
}

TEST_CASE("sharp corners count as 0, and an arc needs edges that turn by less than 23 degrees") {
  for (const std::vector<Vec2>& ring : {square, slab, triangle, l_shape})
    CHECK(wadell_roundness(Outline(ring)) == 0);
  CHECK(wadell_roundness(Outline(rounded(square, 0.2, 3))) == 0);
  CHECK(wadell_roundness(Outline(rounded(square, 0.2, 4))) == to_circle_inside(0.4));
  CHECK(wadell_roundness(Outline(ellipse(1, 1, 15))) == 0);
  for (const int n : {16, 64, 400}) {
    const OutlineCorners found = outline_corners(Outline(ellipse(1, 1, n)));
    CHECK(found.corners.size() == 1);
    CHECK(wadell_roundness(Outline(ellipse(1, 1, n))) == 1);
  }
}

TEST_CASE("a tip on a disc is a corner of its own, and a bulge of a thin plate is none") {
  std::vector<Vec2> drop{{1 / std::cos(pi / 6), 0}};
  for (int k = 0; k <= 60; ++k)
    drop.push_back(Rotation::from_angle(pi / 6 * (1 + k / 6.0)) * Vec2{1, 0});
  CHECK(wadell_roundness(Outline(drop)) == 0.5);
  std::vector<Vec2> plate{{-1, 0}, {1, 0}};
  for (int k = 0; k <= 20; ++k) {
    const double x = 1 - k / 10.0;
    plate.push_back({x, std::sqrt(100 - x * x) - 9.9});
  }
  CHECK(wadell_roundness(Outline(plate)) == 0);
}

TEST_CASE("an L with rounded corners: the five that are convex") {
  for (const double r : {0.05, 0.1, 0.2}) {
    const OutlineCorners found = outline_corners(Outline(rounded(l_shape, r, 64)));
    REQUIRE(found.corners.size() == 5);
    for (const Circle& corner : found.corners) CHECK(corner.radius == near(r, 1e-12));
    // Against two sides and the arc in the concave corner, about (1 + r, 1 + r), whose chords are
    // within r (pi / 256)^2 / 2 of it.
    const double exact = (std::sqrt(2) * (1 + r) - r) / (1 + std::sqrt(2));
    CHECK(found.inside.radius == near_relative(exact, 1e-4 + r * std::pow(pi / 256, 2)));
  }
}

TEST_CASE("an ellipse has two corners, whose radii come down to those of its ends") {
  for (const double a : {1.2, 1.5, 2.0, 3.0})
    for (const double closeness : {0.98, 0.995}) {
      const CornerFit fit{.deviation = 0.15 * (1 - closeness), .closeness = closeness};
      const OutlineCorners found = outline_corners(Outline(ellipse(a, 1, 400)), fit);
      REQUIRE(found.corners.size() == 2);
      // A circle of least squares meets its arc three times: somewhere the radius of curvature is
      // its own, and nowhere is that less than 1 / a. Centred at (c, 0), it is no larger than
      // d / closeness, where d = sqrt(1 - c^2 / (a^2 - 1)) is the distance of the ellipse, and
      // reaches the end: closeness (a - c) <= d / closeness, an inequality of second degree for c.
      const double f = a * a - 1;
      const double s = std::pow(closeness, 4);
      const double p = s + 1 / f;
      const double c = (s * a - std::sqrt(s * s * a * a - p * (s * a * a - 1))) / p;
      const double most = std::sqrt(1 - c * c / f) / closeness;
      // The ends are off by the height of an edge, pi^2 / (2 n^2) of half an axis.
      const double edge = a * std::pow(pi / 400, 2) / 2;
      for (const Circle& corner : found.corners) {
        CHECK(corner.radius >= 1 / a - edge);
        CHECK(corner.radius <= most + edge);
      }
    }
}

TEST_CASE("rounded squares in pixels have four corners and their roundness, once smoothed") {
  // The bound on a radius holds for every circle along a quarter of the arc: half a pixel of error
  // at its ends and, the other way, in its middle changes it by 1 / (1 - cos 45 degrees) pixels. It
  // is less than each radius, so that no corner is sharp. That there is a circle for each corner,
  // and how near their mean is, is measured (docs/shapes.md, with other offsets).
  struct Case {
    double pixels, error;
    std::vector<double> angles;
  };
  for (const auto& [pixels, error, angles] :
       {Case{50, 0.015, {0, 0.01, 0.02, 0.03, 0.05, 0.1, 0.15, 0.2, 0.7}},
        Case{100, 0.012, {0.01, 0.02, 0.05, 0.2}}, Case{200, 0.008, {0.03}}})
    for (const double angle : angles)
      for (const double r : {0.1, 0.2}) {
        CAPTURE(pixels);
        CAPTURE(angle);
        CAPTURE(r);
        const Outline outline =
            smoothed_twice(in_pixels(turned(rounded(square, r), angle), 0.5 / pixels), pixels);
        const OutlineCorners found = outline_corners(outline);
        REQUIRE(found.corners.size() == 4);
        double mean = 0;
        for (const Circle& corner : found.corners) {
          CHECK(corner.radius == near(r, 0.5 / pixels / (1 - std::cos(pi / 4))));
          mean += corner.radius / 4;
        }
        CHECK(mean / found.inside.radius == near(r / 0.5, error));
      }
}

TEST_CASE("ellipses in pixels have two to four corners") {
  // The range of docs/shapes.md, which is measured: steps of the pixels divide corners.
  for (const double pixels : {50.0, 100.0})
    for (const double angle : {0.0, 0.02, 0.05, 0.1, 0.2, 0.3, 0.7}) {
      CAPTURE(pixels);
      CAPTURE(angle);
      const OutlineCorners found = outline_corners(
          smoothed_twice(in_pixels(turned(ellipse(0.75, 0.5, 400), angle), 0.5 / pixels), pixels));
      CHECK(found.corners.size() >= 2);
      CHECK(found.corners.size() <= 4);
      double mean = 0;
      for (const Circle& corner : found.corners)
        mean += corner.radius / static_cast<double>(found.corners.size());
      CHECK(mean / found.inside.radius == near(0.76, 0.09));
    }
}

TEST_CASE("a fit that breaks a rule is refused, and an outline in which it finds no corner") {
  const auto error = [](const CornerFit& fit) {
    return message_of([&] { (void)wadell_roundness(Outline(slab), fit); });
  };
  CHECK(error({.deviation = 0}) == "CornerFit.deviation = 0: must lie in (0, 1)");
  CHECK(error({.closeness = 1}) == "CornerFit.closeness = 1: must lie in (0, 1)");
  // Three corners of the slab lie on no circle so small, and one of 90 degrees might be an edge's.
  CHECK(error({.closeness = 0.5}) ==
        "outline has no corner with CornerFit.deviation = 0.003 and closeness = 0.5: must have one "
        "or more");
}
