// SPDX-License-Identifier: BSL-1.0
#include <riprap/core/vec2.hpp>

#include <concepts>
#include <doctest/doctest.h>
#include <limits>
#include <numbers>

#include <support/near.hpp>

using namespace riprap;
using test::near;

namespace {
constexpr double pi = std::numbers::pi;
}

static_assert(sizeof(Vec2) == 2 * sizeof(double));
static_assert(alignof(Vec2) == alignof(double), "packs into records");

TEST_CASE("the cross product is positive counter-clockwise") {
  CHECK(cross({1, 0}, {0, 1}) == 1);
  CHECK(cross({0, 1}, {1, 0}) == -1);
  CHECK(cross({3, 4}, {-5, 2}) == 26);
  CHECK(cross({3, 4}, {6, 8}) == 0);
}

TEST_CASE("perpendicular turns by +90 degrees") {
  const Vec2 v{3, -4};
  const Vec2 p = perpendicular(v);
  CHECK(p.x() == 4);
  CHECK(p.y() == 3);
  CHECK(cross(v, p) == v.dot(v));
}

TEST_CASE("vectors mix with those of Eigen") {
  const Eigen::Vector2d e(1, 2);
  const Vec2 sum = Vec2{3, 4} + e;
  CHECK(sum.x() == 4);
  CHECK(sum.y() == 6);
}

TEST_CASE("a rotation turns counter-clockwise and its inverse turns back") {
  const Rotation quarter = Rotation::from_angle(pi / 2);
  CHECK((quarter * Vec2{1, 0} - Vec2{0, 1}).norm() <= 1e-16);
  for (const double angle : {-3.0, -1.2, 0.0, 0.4, 2.9}) {
    const Rotation r = Rotation::from_angle(angle);
    const Vec2 v{2, -7};
    const Vec2 turned = r * v;
    // A few roundings of a length of 7.3.
    CHECK(std::abs(turned.norm() - v.norm()) <= 4e-15);
    CHECK((r.inverse_times(turned) - v).norm() <= 4e-15);
    CHECK(std::atan2(cross(v, turned), v.dot(turned)) == near(angle, 1e-15));
  }
}

TEST_CASE("the angle of a rotation is the one it was made from") {
  for (const double angle : {-3.1, -0.5, 0.0, 1e-9, 1.5, 3.1})
    CHECK(std::abs(Rotation::from_angle(angle).angle() - angle) <= 5e-16);
  CHECK(Rotation{}.angle() == 0);
}

TEST_CASE("one turn falls short of its angle by turn^3 / 12") {
  for (const double start : {0.0, 1.1, -2.8})
    for (const double turn : {0.2, 0.1, 0.05, -0.1}) {
      const Rotation before = Rotation::from_angle(start);
      const Rotation after = before.turned(turn);
      const Vec2 relative = before.inverse_times({after.cosine, after.sine});
      const double error = turn - std::atan2(relative.y(), relative.x());
      // Next term of the series of 2 atan(turn / 2), and round-off.
      CHECK(std::abs(error - turn * turn * turn / 12) <= std::pow(std::abs(turn), 5) / 80 + 1e-15);
    }
}

TEST_CASE("a turn and its opposite cancel") {
  const Rotation start = Rotation::from_angle(0.9);
  const Rotation back = start.turned(0.3).turned(-0.3);
  CHECK(std::abs(back.cosine - start.cosine) <= 5e-16);
  CHECK(std::abs(back.sine - start.sine) <= 5e-16);
}

TEST_CASE("a million turns keep unit length and the angle") {
  constexpr int steps = 1000000;
  for (const double turn : {1e-3, 0.4}) {
    Rotation r = Rotation::from_angle(0.2);
    double farthest = 0;
    for (int i = 0; i < steps; ++i) {
      r = r.turned(turn);
      farthest = std::max(farthest, std::abs(std::hypot(r.cosine, r.sine) - 1));
    }
    // Round-off of one step: it must not add up.
    CHECK(farthest <= 5e-16);
    const double expected = 0.2 + steps * 2 * std::atan(turn / 2);
    // Four roundings a step at worst, all of one sign; and those of the expected angle itself.
    const double error = std::remainder(r.angle() - expected, 2 * pi);
    CHECK(std::abs(error) <= steps * 4.5e-16 + 3e-16 * expected);
  }
}

TEST_CASE("one turn brings a stretched rotation back towards unit length") {
  // Newton's step for 1/sqrt leaves 3/2 of the square of the error.
  const Rotation stretched{1 + 1e-4, 0};
  const Rotation r = stretched.turned(0.01);
  CHECK(std::abs(std::hypot(r.cosine, r.sine) - 1) <= 1.6e-8);
}

// A sum, product or quotient of two doubles has one correct rounding: no bit may differ.
TEST_CASE("arithmetic of vectors is that of Eigen, and its results are vectors") {
  const Vec2 a{1.25, -3.1};
  const Vec2 b{-0.7, 2.9};
  const Eigen::Vector2d u = a;
  const Eigen::Vector2d v = b;
  CHECK(a + b == u + v);
  CHECK(a - b == u - v);
  CHECK(-a == -u);
  CHECK(0.3 * a == 0.3 * u);
  CHECK(3 * a == 3.0 * u);
  CHECK(a * 0.3 == u * 0.3);
  CHECK(a / 0.3 == u / 0.3);
  CHECK(0.5 * (a - 2 * b) / 3u == 0.5 * (u - 2 * v) / 3);
  Vec2 sum = a;
  sum += b;
  sum -= 2 * a;
  CHECK(sum == (u + v) - 2 * u);
  static_assert(std::same_as<decltype(0.5 * (a + b) - a / 2), Vec2>);
}

TEST_CASE("componentwise functions take each axis for itself") {
  const Vec2 a{2, -3};
  const Vec2 b{-5, 7};
  CHECK(componentwise_product(a, b) == Vec2(-10, -21));
  CHECK(componentwise_min(a, b) == Vec2(-5, -3));
  CHECK(componentwise_max(a, b) == Vec2(2, 7));
  CHECK(componentwise_abs(a) == Vec2(2, 3));
}

TEST_CASE("a vector is finite if both components are") {
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(is_finite({1e308, -1e308}));
  CHECK(!is_finite({infinity, 0}));
  CHECK(!is_finite({0, -infinity}));
  CHECK(!is_finite({nan, 0}));
  CHECK(!is_finite({0, nan}));
}

TEST_CASE("vectors mix with matrices and expressions of Eigen") {
  const Vec2 a{1, -3};
  const Eigen::Vector2d u{4, 5};
  const Eigen::Matrix2d turn{{0, -1}, {1, 0}};
  CHECK((a + u) == Vec2(5, 2));
  CHECK((u - a) == Vec2(3, 8));
  CHECK((a + turn * a) == Vec2(4, -2));
  CHECK((turn * a - a) == Vec2(2, 4));
  Vec2 sum = a;
  sum += turn * u;
  sum -= u;
  CHECK(sum == Vec2(-8, -4));
}
