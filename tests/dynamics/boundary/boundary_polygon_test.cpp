// SPDX-License-Identifier: BSL-1.0
#include <riprap/dynamics/boundary/boundary_polygon.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

constexpr double pi = std::numbers::pi;

// Corners at the distance `radius` from `centre`, the first in the direction `angle`.
ConvexPolygon regular(int corners, const Vec2& centre, double radius, double angle = 0) {
  std::vector<Vec2> ring;
  for (int k = 0; k < corners; ++k) {
    const double theta = angle + 2 * pi * k / corners;
    ring.push_back(centre + radius * Vec2{std::cos(theta), std::sin(theta)});
  }
  return ConvexPolygon(std::move(ring));
}

ConvexPolygon square(const Vec2& centre, double side, double angle = 0) {
  return regular(4, centre, side * std::sqrt(0.5), angle + pi / 4);
}

// Boundary particles at the corners of the square of side 4, and free ones.
Particles boxed(const std::vector<ConvexPolygon>& free) {
  Particles particles(1, 1);
  for (const Vec2& corner : {Vec2{2, 2}, Vec2{-2, -2}, Vec2{2, -2}, Vec2{-2, 2}})
    particles.add(square(corner, 0.5), Motion::strain_field);
  for (const ConvexPolygon& polygon : free) particles.add(polygon, Motion::free);
  return particles;
}

}  // namespace

TEST_CASE("the area of the assembly is that of the polygon through the boundary centroids") {
  for (const int n : {5, 8, 76}) {
    Particles particles(1, 1);
    // Every third first, for n that 3 does not divide: the polygon sorts them by direction.
    for (int k = 0; k < n; ++k) {
      const double theta = 0.1 + 2 * pi * ((k * 3) % n) / n;
      particles.add(regular(3, 2.5 * Vec2{std::cos(theta), std::sin(theta)}, 0.01),
                    Motion::strain_field);
    }
    const BoundaryPolygon boundary(particles);
    CHECK(boundary.members().size() == static_cast<std::size_t>(n));
    CHECK(boundary.area() == near_relative(0.5 * n * 2.5 * 2.5 * std::sin(2 * pi / n), 1e-13));
  }
}

TEST_CASE("neither free nor prescribed bodies belong to the boundary") {
  Particles particles = boxed({square({0, 0}, 0.3)});
  particles.add(square({0, 1}, 0.2), Motion::prescribed);
  const BoundaryPolygon boundary(particles);
  CHECK(boundary.members().size() == 4);
  CHECK(boundary.area() == near(16, 1e-13));
  CHECK((boundary.semi_axes() - Vec2{2, 2}).norm() == near(0, 1e-14));
}

TEST_CASE("the area follows the strain of the boundary") {
  Particles particles = boxed({});
  const BoundaryPolygon boundary(particles);
  for (const BodyIndex i : boundary.members()) {
    particles.body(i).position.x() *= 1.1;
    particles.body(i).position.y() *= 0.8;
  }
  CHECK(boundary.area() == near(16 * 0.88, 1e-13));
  CHECK((boundary.semi_axes() - Vec2{2.2, 1.6}).norm() == near(0, 1e-14));
}

TEST_CASE("of a boundary particle the part between its two sides counts") {
  // A quarter of each corner square, and the free particles whole.
  const Particles particles = boxed({square({0.5, 0.3}, 0.4, 0.3), square({-1, 0}, 0.2)});
  CHECK(BoundaryPolygon(particles).solid_area() == near(4 * 0.25 / 4 + 0.16 + 0.04, 1e-14));
}

TEST_CASE("a boundary particle in the middle of a side counts half") {
  Particles particles = boxed({});
  particles.add(square({0, 2}, 0.5, 0.2), Motion::strain_field);
  particles.add(square({-2, 0.4}, 0.3, 0.9), Motion::strain_field);
  // A line through the centre of a square halves it, whatever its direction. Corners of turned
  // particles may lie within a millionth of their size of the line and be taken to lie on it.
  CHECK(BoundaryPolygon(particles).solid_area() == near(0.25 + 0.125 + 0.045, 1e-6));
}

TEST_CASE("what neighbours on the ring have in common inside counts once") {
  // In the lower side of a box, two triangles of circumradius 0.5 that point out, 0.2 apart. Five
  // ninths of each lie above its centroid. Their common part is a triangle like them, with the same
  // upper edge at 0.25 above the side and a side shorter by 0.2.
  const double root = std::sqrt(3.0);
  const double edge = 0.5 * root - 0.2;
  const double below = 0.5 * root * edge - 0.25;  // height of its part outside
  const double common = 0.25 * root * edge * edge - below * below / root;
  const double triangle = 0.75 * root * 0.25;
  for (const double angle : {0.0, 0.6, 1.9}) {
    CAPTURE(angle);
    const Rotation turn = Rotation::from_angle(angle);
    Particles particles(1, 1);
    const auto add = [&](const ConvexPolygon& polygon) {
      particles.add(polygon.moved(turn, {0, 0}), Motion::strain_field);
    };
    for (const Vec2& corner : {Vec2{2, 2}, Vec2{-2, 2}, Vec2{-2, -2}, Vec2{2, -2}})
      add(square(corner, 0.5));
    for (const double x : {0.1, 0.3}) add(regular(3, {x, -2}, 0.5, -0.5 * pi));
    CHECK(BoundaryPolygon(particles).solid_area() ==
          near(0.25 + 2 * 5.0 / 9 * triangle - common, 1e-13));
  }
}

TEST_CASE("in a hexagonal ring of hexagons a third of each counts") {
  for (const double angle : {0.0, 0.4, 2.0}) {
    Particles particles(1, 1);
    for (int k = 0; k < 6; ++k) {
      const double theta = angle + pi * k / 3;
      particles.add(regular(6, 3 * Vec2{std::cos(theta), std::sin(theta)}, 0.5, 0.123),
                    Motion::strain_field);
    }
    const double hexagon = 1.5 * std::sqrt(3.0) * 0.25;
    const BoundaryPolygon boundary(particles);
    CHECK(boundary.solid_area() == near(2 * hexagon, 1e-12));
    CHECK(boundary.area() == near(1.5 * std::sqrt(3.0) * 9, 1e-12));
  }
}

TEST_CASE("at a reflex corner the part outside both sides is left out") {
  for (const double angle : {0.0, 0.9, -2.3}) {
    CAPTURE(angle);
    const Rotation turn = Rotation::from_angle(angle);
    Particles particles(1, 1);
    const auto add = [&](const ConvexPolygon& polygon) {
      particles.add(polygon.moved(turn, {0, 0}), Motion::strain_field);
    };
    // A notch of 90 degrees at (1, 0) in the right side of a box; sides at 45 degrees.
    // A triangle lies in it that points out of the box.
    add(regular(3, {1, 0}, 0.2));
    for (const double sign : {1.0, -1.0}) {
      add(square({2, sign}, 0.4));
      add(square({-2, sign}, 0.4));
    }
    const BoundaryPolygon boundary(particles);
    CHECK(boundary.members().size() == 5);
    CHECK(boundary.area() == near(8 - 1, 1e-13));
    // Of a triangle with corners at the distance R from its centroid, (sqrt(3) - 1) R^2 / 2 lies
    // between the two diagonals; an eighth at each of the 45-degree corners, a quarter at the left.
    const double triangle = (0.75 * std::sqrt(3.0) - 0.5 * (std::sqrt(3.0) - 1)) * 0.04;
    CHECK(boundary.solid_area() == near(triangle + 2 * 0.16 / 8 + 2 * 0.16 / 4, 1e-13));
  }
}

TEST_CASE("a particle is lost when its centroid lies outside the boundary") {
  CHECK(BoundaryPolygon(boxed({})).lost() == 0);
  const Particles particles =
      boxed({square({0, 0}, 0.2), square({1.95, 1.9}, 0.5), square({2.05, 0}, 0.5),
             square({0, -7}, 0.1), square({-1.99, -1.99}, 0.1)});
  CHECK(BoundaryPolygon(particles).lost() == 2);
}

TEST_CASE("in a notch of the boundary a particle is lost") {
  Particles particles(1, 1);
  for (const Vec2& corner : {Vec2{1, 0}, Vec2{2, 1}, Vec2{-2, 1}, Vec2{-2, -1}, Vec2{2, -1}})
    particles.add(square(corner, 0.1), Motion::strain_field);
  particles.add(square({1.4, 0}, 0.05), Motion::free);    // in the notch
  particles.add(square({0.9, 0.1}, 0.05), Motion::free);  // behind it
  particles.add(square({1.6, 0.7}, 0.05), Motion::free);  // beside it
  CHECK(BoundaryPolygon(particles).lost() == 1);
}

TEST_CASE("the centre of a ring is that of its circle, exactly the origin for one about it") {
  const auto ring = [](const Vec2& centre, double radius) {
    Particles particles(1, 1);
    // Unevenly spaced: the mean of the centroids is not the centre.
    for (const double theta : {0.0, 0.3, 0.7, 1.0, 2.0, 3.1, 4.5, 5.0, 5.1})
      particles.add(regular(3, centre + radius * Vec2{std::cos(theta), std::sin(theta)}, 0.001),
                    Motion::strain_field);
    return particles;
  };
  for (const double radius : {0.092, 3.0}) {
    const Particles here = ring({0, 0}, radius);
    CHECK(ring_centre(here) == Vec2{0, 0});
    const Vec2 axes = BoundaryPolygon(here).semi_axes();
    for (const Vec2& centre : {Vec2{0.06, 0}, Vec2{-0.1, 7}, Vec2{1000, 1000}}) {
      const Particles moved = ring(centre, radius);
      CHECK((ring_centre(moved) - centre).norm() <= 1e-11 * radius + 1e-12 * centre.norm());
      CHECK((BoundaryPolygon(moved).semi_axes() - axes).norm() <= 1e-11 * (1 + centre.norm()));
      CHECK(BoundaryPolygon(moved).members() == BoundaryPolygon(here).members());
    }
  }
}
