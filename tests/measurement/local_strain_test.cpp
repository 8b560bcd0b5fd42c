// SPDX-License-Identifier: BSL-1.0
#include <riprap/measurement/local_strain.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include <support/message_of.hpp>
#include <support/near.hpp>
#include <support/point_lattice.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

std::vector<MaterialPoint> numbered(const std::vector<Vec2>& positions) {
  std::vector<MaterialPoint> out;
  for (const Vec2& x : positions) out.push_back({static_cast<ParticleId>(3 * out.size() + 1), x});
  return out;
}

template <class Displacement>
std::vector<MaterialPoint> displaced(std::vector<MaterialPoint> points, Displacement&& u) {
  for (MaterialPoint& p : points) p.position += Vec2(u(p.position));
  return points;
}

Vec2 times(const DisplacementGradient& h, const Vec2& x) {
  return {h.h11 * x.x() + h.h12 * x.y(), h.h21 * x.x() + h.h22 * x.y()};
}

void check_same(const DisplacementGradient& found, const DisplacementGradient& expected,
                double tolerance) {
  CHECK(found.h11 == near(expected.h11, tolerance));
  CHECK(found.h12 == near(expected.h12, tolerance));
  CHECK(found.h21 == near(expected.h21, tolerance));
  CHECK(found.h22 == near(expected.h22, tolerance));
}

/// A field that is not linear, of displacements below the distance of the points.
Vec2 wave(const Vec2& x) {
  return {0.02 * std::sin(9 * x.x()) * std::cos(7 * x.y()),
          0.015 * std::cos(5 * x.x() + 8 * x.y())};
}

/// Gauss: 1 / A times the integral of u_i n_j along the edge of the triangulation, where u is
/// linear between points; `of_shape` is the same of the area itself.
DisplacementGradient of_edge(const std::vector<StrainTriangle>& triangles,
                             const std::vector<MaterialPoint>& present) {
  std::map<ParticleId, Vec2> now;
  for (const MaterialPoint& p : present) now[p.id] = p.position;
  std::map<std::pair<ParticleId, ParticleId>, std::pair<Vec2, Vec2>> sides;
  for (const StrainTriangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t l = (k + 1) % 3;
      if (sides.erase({t.ids[l], t.ids[k]}) == 0)
        sides[{t.ids[k], t.ids[l]}] = {t.corners[k], t.corners[l]};
    }
  DisplacementGradient sum;
  double area = 0;
  for (const auto& [ids, ends] : sides) {
    const auto& [p, q] = ends;
    const Vec2 u = 0.5 * ((now[ids.first] - p) + (now[ids.second] - q));
    const Vec2 outward{q.y() - p.y(), p.x() - q.x()};  // times the length
    sum += {u.x() * outward.x(), u.x() * outward.y(), u.y() * outward.x(), u.y() * outward.y()};
    area += 0.5 * cross(p, q);
  }
  return (1 / area) * sum;
}

}  // namespace

TEST_CASE("an affine displacement is found in every triangle and at every point") {
  const auto reference = numbered(shaken_lattice(8, 1, 0.3));
  const DisplacementGradient h{-0.02, 0.11, -0.05, 0.08};
  const auto present = displaced(reference, [&](const Vec2& x) -> Vec2 {
    return Vec2{0.3, -0.7} + times(h, x);
  });
  const auto triangles = local_strain(reference, present);
  CHECK(triangles.size() > 80);
  // Round-off of positions of about 1 m over heights of triangles of 0.02 m or more.
  constexpr double tolerance = 1e-13;
  for (const StrainTriangle& t : triangles) check_same(t.gradient, h, tolerance);
  check_same(mean_gradient(triangles), h, tolerance);
  const auto points = point_gradients(triangles);
  for (const PointGradient& p : points) check_same(p.gradient, h, tolerance);
  CHECK(points.size() == 64);
}

TEST_CASE("the mean over the area is what displacements of the edge give") {
  const auto reference = numbered(shaken_lattice(9, 1, 0.4));
  const auto present = displaced(reference, wave);
  const auto triangles = local_strain(reference, present);
  check_same(mean_gradient(triangles), of_edge(triangles, present), 1e-14);
  // The areas of the triangles now, by their own strains, add up to that of the deformed sample.
  double before = 0;
  double after = 0;
  double by_corners = 0;
  std::map<ParticleId, Vec2> now;
  for (const MaterialPoint& p : present) now[p.id] = p.position;
  for (const StrainTriangle& t : triangles) {
    before += t.area();
    after += t.area() * (1 - t.gradient.volumetric_strain());
    by_corners += 0.5 * cross(now[t.ids[1]] - now[t.ids[0]], now[t.ids[2]] - now[t.ids[0]]);
  }
  CHECK(after == near(by_corners, 1e-14));
  CHECK(before > 0.6);
}

TEST_CASE("the value of a point is the mean over the area of the triangles around it") {
  // A square and its middle, which moves along axis 1: strain h_11 of opposite sign on both sides.
  const auto reference = numbered({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}});
  auto present = reference;
  present[4].position += Vec2{0.1, 0};
  const auto triangles = local_strain(reference, present);
  REQUIRE(triangles.size() == 4);
  const auto points = point_gradients(triangles);
  REQUIRE(points.size() == 5);
  CHECK(points[4].id == reference[4].id);
  check_same(points[4].gradient, {}, 1e-15);
  // Corner 0 has the lower triangle, du_1/dx_2 = 0.1, and the left one, du_1/dx_1 = 0.1.
  check_same(points[0].gradient, {0.05, 0.05, 0, 0}, 1e-15);
}

TEST_CASE("points of one state alone are left out, and the triangles reach across") {
  const auto reference = numbered(shaken_lattice(7, 1, 0.2));
  auto present = displaced(reference, wave);
  const std::size_t inner = 24;  // the middle one of 49
  const ParticleId gone = present[inner].id;
  present[inner].id = gone + 1;  // a piece
  const auto triangles = local_strain(reference, present);
  double area = 0;
  for (const StrainTriangle& t : triangles) {
    area += t.area();
    for (const ParticleId id : t.ids) CHECK((id != gone && id != gone + 1));
  }
  double whole = 0;
  const auto all = local_strain(reference, displaced(reference, wave));
  for (const StrainTriangle& t : all) whole += t.area();
  CHECK(area == near(whole, 1e-14));
  CHECK(triangles.size() == all.size() - 2);
}

TEST_CASE("nothing in common is no strain, and ids out of order and infinite places are refused") {
  const auto points = numbered(shaken_lattice(3, 1, 0.2));
  CHECK(local_strain(points, {}).empty());
  CHECK(mean_gradient({}).h11 == 0);
  CHECK(point_gradients({}).empty());
  auto wrong = points;
  std::swap(wrong[1], wrong[2]);
  CHECK(contains(message_of([&] { (void)local_strain(points, wrong); }),
                 "local_strain: id of a point = 4: must be above"));
  wrong = points;
  wrong[4].position.x() = std::numeric_limits<double>::infinity();
  CHECK(contains(message_of([&] { (void)local_strain(points, wrong); }),
                 "local_strain: displacement of a point = inf"));
}
