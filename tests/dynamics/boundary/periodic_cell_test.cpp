// SPDX-License-Identifier: BSL-1.0
#include <riprap/dynamics/boundary/periodic_cell.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

Particles two_triangles() {
  Particles particles(1, 1);
  const ConvexPolygon triangle{{0, 0}, {1, 0}, {0, 1}};
  particles.add(triangle, Motion::free);
  particles.add(triangle.moved({}, {40, -30}), Motion::free);
  return particles;
}

}  // namespace

TEST_CASE("the sample is the cell, from which nothing is lost") {
  const Particles particles = two_triangles();
  PeriodicCell cell;
  cell.enclose({.particles = {}, .period = {4, 2}}, particles);
  const auto region = cell.region(particles);
  CHECK(region.area() == 8);
  CHECK(region.semi_axes() == Vec2{2, 1});
  CHECK(region.solid_area() == near(1, 1e-15));
  CHECK(region.lost() == 0);
}

TEST_CASE("at a constant rate the cell shrinks exponentially") {
  const Particles particles = two_triangles();
  PeriodicCell cell;
  cell.enclose({.particles = {}, .period = {4, 2}}, particles);
  cell.set_rate(0.5, -0.1);
  constexpr int steps = 1000;
  for (int n = 0; n < steps; ++n) cell.drift(1.0 / steps);
  // (1 - x/n)^n = exp(-x) (1 - x^2 / 2n + ...).
  CHECK(cell.domain().period.x() == near_relative(4 * std::exp(-0.5), 0.5 * 0.25 / steps * 1.1));
  CHECK(cell.domain().period.y() == near_relative(2 * std::exp(0.1), 0.5 * 0.01 / steps * 1.1));
  CHECK(cell.domain().rate == Vec2{0.5, -0.1});
}

TEST_CASE("a sheared cell keeps its area, and its offset has no limit") {
  const Particles particles = two_triangles();
  PeriodicCell cell;
  cell.enclose({.particles = {}, .period = {4, 2}, .shear_offset = 1}, particles);
  CHECK(cell.domain().shear_offset == 1);
  cell.set_shear_rate(0.25);
  CHECK(cell.shear_rate() == 0.25);
  // 0.25 / s times 2 m in 16 s.
  for (int n = 0; n < 64; ++n) cell.drift(0.25);
  CHECK(cell.domain().shear_offset == 9);
  CHECK(cell.region(particles).area() == 8);
  CHECK_THROWS_WITH_AS(cell.set_shear_rate(std::nan("")),
                       "PeriodicCell: shear rate = nan: must be a finite number", InvalidInput);
}

TEST_CASE("boundary bodies in a periodic cell are an error") {
  Particles particles = two_triangles();
  particles.body(1).motion = Motion::platen;
  PeriodicCell cell;
  CHECK_THROWS_WITH_AS(cell.enclose({.particles = {}, .period = {4, 2}}, particles),
                       "particle 1: a PeriodicCell has no boundary bodies", InvalidInput);
}

TEST_CASE("an assembly without a period is an error") {
  PeriodicCell cell;
  CHECK_THROWS_WITH_AS(
      cell.enclose({.particles = {}, .period = {1, 0}}, two_triangles()),
      "PeriodicCell: Assembly.period along axis 2 = 0: must be a finite number above 0",
      InvalidInput);
}
