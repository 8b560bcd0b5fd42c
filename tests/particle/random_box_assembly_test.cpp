// SPDX-License-Identifier: BSL-1.0
#include <riprap/particle/random_box_assembly.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include <riprap/geometry/overlap.hpp>
#include <riprap/particle/random_assembly.hpp>
#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

const RandomAssembly options{.count = 150, .seed = 5};

std::vector<ConvexPolygon> grains(const Assembly& assembly) {
  std::vector<ConvexPolygon> out;
  for (const PlacedParticle& p : assembly.particles)
    if (p.motion == Motion::free) out.push_back(p.polygon);
  return out;
}

double area_of(const std::vector<ConvexPolygon>& polygons) {
  double sum = 0;
  for (const ConvexPolygon& p : polygons) sum += area_properties(p.ring()).area;
  return sum;
}

bool overlap_in_area(const ConvexPolygon& p, const ConvexPolygon& q) {
  return overlap(p.ring(), q.ring(), {0, 0}, 0).size > 0;
}

}  // namespace

TEST_CASE("between platens all particles are free, inside and apart, at the solid fraction") {
  const Assembly assembly = random_platen_assembly(options);
  REQUIRE(assembly.particles.size() == 154);
  const auto inside = grains(assembly);
  REQUIRE(inside.size() == 150);
  double half = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(assembly.particles[i].motion == Motion::platen);
    // The first one stands on the right.
    if (i == 0) half = assembly.particles[i].polygon.ring()[0].x();
    for (const ConvexPolygon& p : inside)
      CHECK_FALSE(overlap_in_area(assembly.particles[i].polygon, p));
  }
  for (const ConvexPolygon& p : inside)
    for (const Vec2& v : p) CHECK(v.cwiseAbs().maxCoeff() < half);
  CHECK(area_of(inside) / (4 * half * half) == near(options.solid_fraction, 1e-12));
  for (std::size_t i = 0; i < inside.size(); ++i)
    for (std::size_t j = i + 1; j < inside.size(); ++j)
      CHECK_FALSE(overlap_in_area(inside[i], inside[j]));
  CHECK(assembly.period == Vec2{0, 0});
}

TEST_CASE("in a periodic cell no particle overlaps an image of another") {
  const Assembly assembly = random_periodic_assembly(options);
  const auto inside = grains(assembly);
  REQUIRE(inside.size() == 150);
  REQUIRE(assembly.particles.size() == 150);
  const double side = assembly.period.x();
  CHECK(assembly.period.y() == side);
  CHECK(area_of(inside) / (side * side) == near(options.solid_fraction, 1e-12));
  bool crosses = false;
  for (std::size_t i = 0; i < inside.size(); ++i) {
    for (const Vec2& v : inside[i]) crosses |= v.cwiseAbs().maxCoeff() > 0.5 * side;
    for (std::size_t j = i + 1; j < inside.size(); ++j)
      for (int p = -1; p <= 1; ++p)
        for (int q = -1; q <= 1; ++q)
          CHECK_FALSE(overlap_in_area(inside[i], inside[j].moved({}, {p * side, q * side})));
  }
  CHECK(crosses);  // else the border would be a wall
}

TEST_CASE(
    "boxes and cells of any aspect ratio hold the same particles at the same solid fraction") {
  for (const double aspect : {0.25, 1.0, 3.0}) {
    CAPTURE(aspect);
    const RandomAssembly of{.count = 150, .seed = 5, .aspect_ratio = aspect, .walls = Motion::wall};
    const Assembly box = random_platen_assembly(of);
    // Inner faces: right, left, top, bottom.
    const double right = box.particles[0].polygon.ring()[0].x();
    const double top =
        area_properties(box.particles[2].polygon.ring()).centroid.y() - 0.5 * of.mean_diameter;
    CHECK(right / top == near_relative(aspect, 1e-12));
    CHECK(area_of(grains(box)) / (4 * right * top) == near(of.solid_fraction, 1e-12));
    for (std::size_t k = 0; k < 4; ++k) {
      const PlacedParticle& wall = box.particles[k];
      CHECK(wall.motion == Motion::wall);
      const Vec2 centre = area_properties(wall.polygon.ring()).centroid;
      const double out = (k % 2 == 0 ? 1.0 : -1.0) * ((k < 2 ? right : top) + 0.5 * 0.016);
      CHECK((centre - (k < 2 ? Vec2{out, 0} : Vec2{0, out})).norm() <= 1e-14);
      CHECK(area_properties(wall.polygon.ring()).area ==
            near_relative(0.016 * 4 * (k < 2 ? top : right), 1e-12));
    }
    for (const ConvexPolygon& p : grains(box))
      for (const Vec2& v : p) CHECK((std::abs(v.x()) < right && std::abs(v.y()) < top));

    const Assembly cell = random_periodic_assembly(of);
    CHECK(cell.period.x() / cell.period.y() == near_relative(aspect, 1e-12));
    const auto inside = grains(cell);
    CHECK(area_of(inside) / cell.period.prod() == near(of.solid_fraction, 1e-12));
    for (std::size_t i = 0; i < inside.size(); ++i)
      for (std::size_t j = i + 1; j < inside.size(); ++j)
        for (int p = -1; p <= 1; ++p)
          for (int q = -1; q <= 1; ++q)
            CHECK_FALSE(overlap_in_area(
                inside[i], inside[j].moved({}, Vec2{p * cell.period.x(), q * cell.period.y()})));
  }
}

TEST_CASE("box assemblies: same seed, same bytes; another seed, another assembly") {
  for (const auto make : {random_platen_assembly, random_periodic_assembly}) {
    const auto first = grains(make(options));
    const auto again = grains(make(options));
    const auto other = grains(make({.count = 150, .seed = 6}));
    CHECK(first.back().ring()[0] == again.back().ring()[0]);
    CHECK(first.back().ring()[0] != other.back().ring()[0]);
  }
}

TEST_CASE("box assemblies check their options") {
  CHECK_THROWS_AS((void)random_platen_assembly({.count = 3}), InvalidInput);
  CHECK_THROWS_AS((void)random_periodic_assembly({.thickness = 0}), InvalidInput);
  CHECK_THROWS_WITH_AS((void)random_platen_assembly({.aspect_ratio = 0}),
                       "RandomAssembly.aspect_ratio = 0: must be a finite number above 0",
                       InvalidInput);
  CHECK_THROWS_WITH_AS((void)random_platen_assembly({.walls = Motion::free}),
                       "RandomAssembly.walls = 0: must be Motion::platen or Motion::wall",
                       InvalidInput);
  CHECK_THROWS_WITH_AS((void)random_assembly({.aspect_ratio = 2}),
                       "RandomAssembly.aspect_ratio = 2: must be 1 for a circle", InvalidInput);
}
