// SPDX-License-Identifier: BSL-1.0
#include <riprap/geometry/cut.hpp>

#include <algorithm>
#include <doctest/doctest.h>
#include <string>

#include <riprap/core/random.hpp>
#include <riprap/geometry/convex_polygon.hpp>
#include <riprap/geometry/random_polygon.hpp>

#include <support/near.hpp>
#include <support/polygons.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

double polar_about(const AreaProperties& p, const Vec2& point) {
  return p.polar_moment + p.area * (p.centroid - point).squaredNorm();
}

/// Area, first and polar moment of the parts add up to those of the whole, within `error` times
/// the powers of its size.
void check_sums(Ring whole, const std::vector<std::vector<Vec2>>& parts, double error) {
  const AreaProperties w = area_properties(whole);
  const double size = diameter(whole);
  double area = 0;
  Vec2 first{0, 0};
  double polar = 0;
  for (const std::vector<Vec2>& part : parts) {
    const AreaProperties p = area_properties(part);
    area += p.area;
    first += p.area * (p.centroid - w.centroid);
    polar += polar_about(p, w.centroid);
  }
  CHECK(std::abs(area - w.area) <= error * size * size);
  CHECK(first.norm() <= error * size * size * size);
  CHECK(std::abs(polar - w.polar_moment) <= error * std::pow(size, 4));
}

Line random_line(const ConvexPolygon& polygon, Random& random) {
  const double reach = 0.3 * diameter(polygon.ring());
  const Vec2 centre = area_properties(polygon.ring()).centroid;
  const Vec2 offset{random.uniform(-reach, reach), random.uniform(-reach, reach)};
  return {centre + offset, Rotation::from_angle(random.uniform(0, 2 * pi)) * Vec2{1, 0}};
}

}  // namespace

TEST_CASE("a unit square cut at x = 0.3 gives rectangles of 0.3 and 0.7") {
  // Upwards: what is left of x = 0.3 lies on the left of the line.
  const auto parts = cut(unit_square().ring(), {{0.3, 5}, {0, 1}});
  REQUIRE(parts);
  const AreaProperties left = area_properties(parts->left);
  const AreaProperties right = area_properties(parts->right);
  // Round-off of numbers near one.
  CHECK(std::abs(left.area - 0.3) <= 4e-16);
  CHECK(std::abs(right.area - 0.7) <= 4e-16);
  CHECK((left.centroid - Vec2{0.15, 0.5}).norm() <= 4e-16);
  CHECK((right.centroid - Vec2{0.65, 0.5}).norm() <= 4e-16);
  CHECK(std::abs(left.polar_moment - 0.3 * (0.09 + 1) / 12) <= 4e-16);
  CHECK(std::abs(right.polar_moment - 0.7 * (0.49 + 1) / 12) <= 4e-16);
  const Vec2 centre{0.5, 0.5};
  CHECK(std::abs(polar_about(left, centre) + polar_about(right, centre) - 1.0 / 6) <= 4e-16);
}

TEST_CASE("the direction of the line decides which part is the left one") {
  const auto up = cut(unit_square().ring(), {{0.3, 0}, {0, 1}});
  const auto down = cut(unit_square().ring(), {{0.3, 0}, {0, -1}});
  REQUIRE(up);
  REQUIRE(down);
  CHECK(area_properties(up->left).area == area_properties(down->right).area);
  CHECK(area_properties(up->right).area == area_properties(down->left).area);
  CHECK(area_properties(up->left).area < 0.31);
}

TEST_CASE("the distance from a line is positive on its left") {
  const Line line{{1, 1}, {0.6, 0.8}};
  CHECK(line.left_distance({1 - 0.8, 1 + 0.6}) == near_relative(1, 1e-15));
  CHECK(line.left_distance({1 + 1.6, 1 - 1.2}) == near_relative(-2, 1e-15));
  CHECK(std::abs(line.left_distance({1 + 3 * 0.6, 1 + 3 * 0.8})) <= 1e-15);
}

TEST_CASE("area and moments of random cuts add up, and both parts are convex") {
  Random random(2024);
  for (int trial = 0; trial < 300; ++trial) {
    const ConvexPolygon shape = random_polygon({.most_vertices = 9}, 1, random);
    const Line line = random_line(shape, random);
    for (const Pose& pose : poses(1)) {
      const ConvexPolygon whole = pose.of(shape);
      const auto parts = cut(whole.ring(), {pose.of(line.point), pose.rotation * line.direction});
      if (!parts) continue;
      check_sums(whole.ring(), {parts->left, parts->right}, 4e-15 * pose.digits);
      CHECK(parts->left.size() + parts->right.size() <= whole.size() + 4);
      // Both contain the two ends of the cut; so little area may be left that the polygon's own
      // check would not accept it, but none turns right.
      for (const std::vector<Vec2>& part : {parts->left, parts->right}) {
        REQUIRE(part.size() >= 3);
        if (area_properties(part).area > 1e-4) CHECK_NOTHROW(ConvexPolygon{part});
      }
    }
  }
}

TEST_CASE("every part lies on its side of the line") {
  Random random(77);
  int cuts = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const ConvexPolygon polygon = random_polygon({}, 1, random);
    const Line line = random_line(polygon, random);
    const auto parts = cut(polygon.ring(), line);
    if (!parts) continue;
    ++cuts;
    // A vertex may lie beyond the line by a millionth of the diameter.
    const double snap = 1e-6 * diameter(polygon.ring());
    for (const Vec2& v : parts->left) CHECK(line.left_distance(v) >= -snap);
    for (const Vec2& v : parts->right) CHECK(line.left_distance(v) <= snap);
  }
  CHECK(cuts > 150);
}

TEST_CASE("the parts of parts still add up to the whole") {
  Random random(5);
  for (int trial = 0; trial < 100; ++trial) {
    const ConvexPolygon whole = random_polygon({}, 1, random);
    std::vector<std::vector<Vec2>> parts = {{whole.begin(), whole.end()}};
    for (int generation = 0; generation < 3; ++generation) {
      std::vector<std::vector<Vec2>> next;
      for (const std::vector<Vec2>& part : parts) {
        const Vec2 centre = area_properties(part).centroid;
        const double angle = random.uniform(0, 2 * pi);
        const auto halves = cut(part, {centre, Rotation::from_angle(angle) * Vec2{1, 0}});
        REQUIRE(halves);  // a line through the centroid leaves something on both sides
        next.push_back(halves->left);
        next.push_back(halves->right);
      }
      parts = next;
    }
    REQUIRE(parts.size() == 8);
    check_sums(whole.ring(), parts, 1e-14);
  }
}

TEST_CASE("a cut through two vertices adds none") {
  const auto parts = cut(unit_square().ring(), {{0, 0}, Vec2{1, 1} / std::sqrt(2.0)});
  REQUIRE(parts);
  CHECK(parts->left == std::vector<Vec2>{{0, 0}, {1, 1}, {0, 1}});
  CHECK(parts->right == std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1}});
}

TEST_CASE("a cut through one vertex adds one point on the opposite edge, to both parts") {
  const auto parts = cut(unit_square().ring(), {{0, 0}, Vec2{1, 2} / std::sqrt(5.0)});
  REQUIRE(parts);
  REQUIRE(parts->left.size() == 3);
  REQUIRE(parts->right.size() == 4);
  CHECK(std::abs(area_properties(parts->left).area - 0.25) <= 4e-16);
  // The same bits on both sides.
  CHECK(parts->left[1] == parts->right[3]);
  CHECK((parts->left[1] - Vec2{0.5, 1}).norm() <= 4e-16);
}

TEST_CASE("a line along an edge, through a single vertex or past the ring cuts nothing") {
  const ConvexPolygon square = unit_square();
  for (const double sign : {1.0, -1.0}) {
    CHECK_FALSE(cut(square.ring(), {{0.3, 0}, {sign, 0}}));
    CHECK_FALSE(cut(square.ring(), {{1, 0.3}, {0, sign}}));
    CHECK_FALSE(cut(square.ring(), {{0, 0}, sign * Vec2{1, -1} / std::sqrt(2.0)}));
    CHECK_FALSE(cut(square.ring(), {{2, 0}, {0, sign}}));
    CHECK_FALSE(cut(square.ring(), {{0, -1}, sign * Vec2{0.8, 0.6}}));
  }
}

TEST_CASE("a vertex within a millionth of the diameter of the line lies on it") {
  for (const double size : {1e-3, 1.0, 1e3}) {
    const ConvexPolygon square = scaled(unit_square(), size);
    // Diameter 1.41 sizes: half a millionth inside an edge is no cut, three millionths are one.
    CHECK_FALSE(cut(square.ring(), {{0.5e-6 * size, 0}, {0, 1}}));
    const auto thin = cut(square.ring(), {{3e-6 * size, 0}, {0, 1}});
    REQUIRE(thin);
    // Digits of 1e-16 of the size, over a width of 3e-6 of it.
    CHECK(area_properties(thin->left).area == near_relative(3e-6 * size * size, 1e-10));
    // Just beside two opposite corners: no edge of a millionth of the size is made.
    const auto diagonal = cut(square.ring(), {{0.7e-6 * size, 0}, Vec2{1, 1} / std::sqrt(2.0)});
    REQUIRE(diagonal);
    CHECK(diagonal->left.size() == 3);
    CHECK(diagonal->right.size() == 3);
  }
}

TEST_CASE("an edge shorter than the snap distance belongs to one piece") {
  const std::vector<Vec2> bevelled{{0, 0}, {1, 0}, {1, .9987}, {.9987, 1}, {0, 1}};
  const Line diagonal{{0, 0}, Vec2{1, 1} / std::sqrt(2.0)};
  const auto parts = cut(bevelled, diagonal, 1e-3);
  REQUIRE(parts);
  CHECK(parts->left == std::vector<Vec2>{{0, 0}, {1, .9987}, {.9987, 1}, {0, 1}});
  CHECK(parts->right == std::vector<Vec2>{{0, 0}, {1, 0}, {1, .9987}});
  check_sums(bevelled, {parts->left, parts->right}, 4e-16);
}

namespace {

/// A random convex ring of one of several kinds: plain, with short edges at its corners, a needle,
/// with 64 vertices.
ConvexPolygon random_ring(Random& random) {
  const ConvexPolygon plain = random_polygon({.most_vertices = 9}, 1, random);
  switch (random.uniform_integer(0, 3)) {
  case 0: {
    std::vector<Vec2> bevelled;
    for (std::size_t i = 0; i < plain.size(); ++i) {
      const double share = std::pow(10, random.uniform(-8, -1));
      const Vec2 v = plain[i];
      bevelled.push_back(v + share * (plain[(i + plain.size() - 1) % plain.size()] - v));
      bevelled.push_back(v + share * (plain[(i + 1) % plain.size()] - v));
    }
    return try_convex_polygon(bevelled).value_or(plain);
  }
  case 1: {
    const double thin = std::pow(10, random.uniform(-5, 0));
    std::vector<Vec2> needle;
    for (const Vec2& v : plain) needle.push_back({v.x(), thin * v.y()});
    return try_convex_polygon(needle).value_or(plain);
  }
  case 2:
    return scaled(regular_polygon(64, 1), random.uniform(0.5, 2));
  default:
    return plain;
  }
}

/// A line through the ring, through two of its corners, along an edge, or beside one of these by a
/// small share of the size.
Line line_near(Ring ring, Random& random) {
  const auto vertex = [&] {
    return ring[random.uniform_integer(0, static_cast<unsigned>(ring.size()) - 1)];
  };
  const Vec2 p = random.uniform(0, 1) < 0.5 ? vertex() : area_properties(ring).centroid;
  const Vec2 q = vertex();
  const Vec2 across = q - p;
  const double angle = random.uniform(0, 2 * pi);
  const double nearby = random.uniform(0, 1) < 0.3 ? 0 : std::pow(10, random.uniform(-16, 0));
  const Vec2 shift = nearby * Vec2{std::cos(angle), std::sin(angle)};
  if (across.norm() == 0) return {p + shift, {std::cos(angle), std::sin(angle)}};
  return {p + shift, across / across.norm()};
}

/// By the shoelace formula, in more digits than the library's.
long double long_area(Ring ring) {
  const auto from_first = [&](std::size_t i, int axis) {
    const auto k = i % ring.size();
    return static_cast<long double>(ring[k][axis]) - static_cast<long double>(ring[0][axis]);
  };
  long double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    sum += (from_first(i + 1, 0) - from_first(i, 0)) * (from_first(i, 1) + from_first(i + 1, 1));
  return -sum / 2;
}

/// The first rule of a cut that two pieces break, or an empty text.
std::string broken_rule(Ring ring, const CutRings& parts) {
  const long double area = long_area(ring);
  if (!(std::abs(long_area(parts.left) + long_area(parts.right) - area) <= 1e-12L * area))
    return "areas do not add up";
  if (parts.left.size() < 3 || parts.right.size() < 3) return "a piece without corners";
  // Both ends of the cut and no other vertex are shared.
  std::size_t shared = 0;
  for (const Vec2& v : parts.left)
    shared += static_cast<std::size_t>(std::count(parts.right.begin(), parts.right.end(), v));
  if (shared != 2) return "the pieces share " + std::to_string(shared) + " vertices";
  // An end of the cut is a vertex of the ring or a new one.
  std::size_t kept = 0;
  for (const std::vector<Vec2>* piece : {&parts.left, &parts.right})
    for (const Vec2& v : *piece)
      kept += static_cast<std::size_t>(std::count(ring.begin(), ring.end(), v));
  const std::size_t all = parts.left.size() + parts.right.size();
  if (kept < ring.size() || all - kept > 4) return "a vertex is lost or made";
  return {};
}

}  // namespace

TEST_CASE("a million random cuts, and cuts of cuts, neither make nor lose area") {
  Random random(12);
  std::size_t cuts = 0;
  std::string broken;
  while (cuts < 1'000'000 && broken.empty()) {
    const ConvexPolygon whole = random_ring(random);
    std::vector<std::vector<Vec2>> rings{{whole.begin(), whole.end()}};
    for (int generation = 0; generation < 4; ++generation) {
      std::vector<std::vector<Vec2>> next;
      for (const std::vector<Vec2>& ring : rings) {
        const double snap = std::pow(10, random.uniform(-9, -2));
        const auto parts = cut(ring, line_near(ring, random), snap);
        if (!parts) continue;
        ++cuts;
        if (broken.empty()) broken = broken_rule(ring, *parts);
        for (const std::vector<Vec2>& piece : {parts->left, parts->right})
          if (try_convex_polygon(piece)) next.push_back(piece);
      }
      rings = next;
    }
  }
  CHECK(broken == "");
  CHECK(cuts >= 1'000'000);
}

TEST_CASE("without a snap distance an end that is rounded to a vertex comes once in each piece") {
  Random random(14);
  int cuts = 0;
  std::string broken;
  for (int trial = 0; trial < 100'000; ++trial) {
    const ConvexPolygon whole = random_ring(random);
    const auto parts = cut(whole.ring(), line_near(whole.ring(), random), 0);
    if (!parts) continue;
    ++cuts;
    if (broken.empty()) broken = broken_rule(whole.ring(), *parts);
  }
  CHECK(broken == "");
  CHECK(cuts > 50'000);
}
