// SPDX-License-Identifier: BSL-1.0
#include <riprap/geometry/smoothed_outline.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <riprap/geometry/line_side.hpp>
#include <riprap/geometry/ring_distance.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>
#include <support/polygons.hpp>

using namespace riprap;
using namespace riprap::test;

TEST_CASE("a circle shrinks by the fourth power of the width over its radius") {
  std::vector<Vec2> vertices;
  for (int k = 0; k < 2000; ++k)
    vertices.push_back(Rotation::from_angle(2 * pi * k / 2000) * Vec2{3, 0});
  // 100 points. Of their weights the fourth moment is -(3 / 35) 7 8 9 10 steps; the sixth adds a
  // hundredth of it here, and edges are 1e-6 inside the circle.
  const double step = 2 * pi / 100;
  const double share = 3.0 / 35 * 5040 * std::pow(step, 4) / 24;
  const Outline smoothed = smoothed_outline(Outline(vertices), 8 * 3 * step);
  for (const Vec2& v : smoothed.ring()) CHECK(v.norm() / 3 == near(1 - share, 0.02 * share));
}

TEST_CASE("straight sides stay where they are, and steps of a diagonal go") {
  const Outline square({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  const Outline smoothed = smoothed_outline(square, 0.2);
  for (const Vec2& corner : square.ring()) CHECK(distance_to_ring(corner, smoothed.ring()) > 0.01);
  for (const double t : {0.21, 0.5, 0.79})
    for (const Vec2& p : {Vec2{t, 0}, Vec2{t, 1}, Vec2{0, t}, Vec2{1, t}})
      CHECK(distance_to_ring(p, smoothed.ring()) < 1e-14);
  // A staircase of 100 pixels along the diagonal of a triangle, which is off the middle of the
  // steps by 0.35 pixels.
  std::vector<Vec2> stairs{{0, 0}, {100, 0}};
  for (int k = 1; k <= 100; ++k) {
    stairs.push_back({100.0 - k + 1, static_cast<double>(k)});
    if (k < 100) stairs.push_back({100.0 - k, static_cast<double>(k)});
  }
  stairs.push_back({0, 100});
  const Outline slope = smoothed_outline(Outline(stairs), 8);
  for (const Vec2& v : slope.ring())
    if (std::min(v.x(), v.y()) > 10)
      CHECK((v.x() + v.y() - 100.5) / std::sqrt(2) == near(0, 0.35 / 8));
}

namespace {

/// What stays of the cosine of a length, in half widths: the value in the middle of the parabola of
/// least squares, by its normal equations.
double gain(double wavelength) {
  double s0 = 0, s2 = 0, s4 = 0, c0 = 0, c2 = 0;
  for (int j = -8; j <= 8; ++j) {
    const double square = j * j;
    const double value = std::cos(2 * pi * j / (8 * wavelength));
    s0 += 1;
    s2 += square;
    s4 += square * square;
    c0 += value;
    c2 += square * value;
  }
  return (s4 * c0 - s2 * c2) / (s0 * s4 - s2 * s2);
}

}  // namespace

TEST_CASE("of the steps of a slope stays what the gain leaves of each of their harmonics") {
  for (const int n : {5, 10, 16, 20, 40}) {
    // One pixel up, diagonally, in n along; the length of a period has n - 1 straight steps.
    const int periods = 60;
    const double side = n * periods;
    std::vector<Vec2> stairs;
    for (int k = 0; k < periods; ++k) {
      stairs.push_back({n * k, k});
      stairs.push_back({n * k + n - 1, k});
    }
    stairs.push_back({side, periods});
    stairs.push_back({side, side});
    stairs.push_back({0, side});
    const Outline smoothed = smoothed_outline(Outline(stairs), 8);
    // The distance above the middle line, squared, over all edges of whole periods.
    const auto above = [&](const Vec2& v) { return v.y() - v.x() / n + 0.5 * (n - 1) / n; };
    const Ring ring = smoothed.ring();
    double squares = 0, width = 0;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Vec2& from = ring[k];
      const Vec2& to = ring[next_vertex(k, ring.size())];
      if (from.x() < 5 * n || to.x() > side - 5 * n || to.y() > periods + 2) continue;
      const double a = above(from), b = above(to);
      squares += (a * a + a * b + b * b) / 3 * (to.x() - from.x());
      width += to.x() - from.x();
    }
    REQUIRE(width > 48 * n);
    // A triangle wave that rises over a share of its length, sqrt(2) of it all.
    const double length = n - 1 + std::sqrt(2);
    const double share = std::sqrt(2) / length;
    double expected = 0, rest = 0;
    for (int m = 1; m < 1000; ++m) {
      const double amplitude =
          (n - 1.0) / n * std::sin(m * pi * share) / (m * m * pi * pi * share * (1 - share));
      const double square = amplitude * amplitude / 2;
      if (length / m > 2)
        expected += std::pow(gain(length / m / 8), 2) * square;
      else
        rest += square;
    }
    // Harmonics of less than two points may pass for any longer one, of which 1 stays at most. The
    // part of a period left over in 50 is a hundredth of the mean, chords between points are
    // (2 pi / length)^2 / 12 of it inside: 0.004 at most.
    CHECK(std::sqrt(squares / width) == near(std::sqrt(expected), std::sqrt(rest) + 0.004));
  }
}

TEST_CASE("a width that smooths too much is refused") {
  const Outline square({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  for (const double width : {0.0, 1.01})
    CHECK(contains(message_of([&] { (void)smoothed_outline(square, width); }),
                   "must be above 0 and at most a quarter of the perimeter"));
}
