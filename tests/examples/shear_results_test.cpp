// SPDX-License-Identifier: BSL-1.0
// What the examples of shear tests compute.

#include <doctest/doctest.h>
#include <shear_tests/broken_mass.hpp>
#include <shear_tests/results.hpp>

#include <cmath>
#include <numbers>

#include <riprap/core/errors.hpp>
#include <riprap/core/vec2.hpp>
#include <shear_tests/options.hpp>
#include <support/near.hpp>
#include <support/rectangle.hpp>

using namespace riprap;
using namespace riprap::test;
using namespace shear_tests;

namespace {
constexpr double degree = std::numbers::pi / 180;
}

TEST_CASE("the envelope of points on a straight line is that line") {
  std::vector<Vec2> points;
  for (const double sigma : {1e6, 4e6, 8e6})
    points.push_back({sigma, 2e5 + std::tan(35 * degree) * sigma});
  const Envelope e = envelope(points);
  CHECK(e.angle == near_relative(35, 1e-9));
  CHECK(e.cohesion == near_relative(2e5, 1e-9));
  // Least squares through the origin: sum of x y over sum of x^2.
  const double slope = std::tan(35 * degree) + 2e5 * 13e6 / 81e12;
  CHECK(e.secant_angle == near_relative(std::atan(slope) / degree, 1e-9));
  const Envelope one = envelope({{2e6, 2e6}});
  CHECK(std::isnan(one.angle));
  CHECK(one.secant_angle == near_relative(45, 1e-12));
}

TEST_CASE("R^2 is the share of the variance that the line explains") {
  CHECK(straight_line({{0, 1}, {1, 3}, {2, 5}}).r_squared == near_relative(1, 1e-12));
  // Deviations of +-1 that are orthogonal to 1 and x, from a line of slope 1 over x = -2 .. 2:
  // variance of the line 2, of the deviations 14 / 5.
  const std::vector<Vec2> points{{-2, -2 + 2}, {-1, -1 - 1}, {0, -2}, {1, 1 - 1}, {2, 2 + 2}};
  const StraightLine fit = straight_line(points);
  CHECK(fit.line.slope == near_relative(1, 1e-12));
  CHECK(fit.r_squared == near_relative(2 / (2 + 14.0 / 5), 1e-12));
}

TEST_CASE("curves are averaged point by point, points by intervals") {
  const auto mean = mean_curve({{{0, 1}, {1, 2}, {2, 9}}, {{0, 3}, {1, 6}}});
  REQUIRE(mean.size() == 2);
  CHECK(mean[1] == Vec2{1, 4});
  const auto means = bin_means({{0.1, 1}, {0.2, 3}, {0.9, 5}, {1, 7}, {-0.1, 7}}, 0, 1, 4);
  REQUIRE(means.size() == 2);
  CHECK(means[0] == Vec2{0.125, 2});
  CHECK(means[1] == Vec2{0.875, 5});
}

TEST_CASE("the major stress of simple shear lies at 135 degrees, further on where it dilates") {
  for (const double angle : {0.0, 20.0, 90.0, 135.0, 170.0}) {
    const Stress2 s = Stress2{3, 1, 0}.rotated(Rotation::from_angle(angle * degree));
    CHECK(major_direction(s) == near(angle, 1e-9));
  }
  CHECK(major_direction_of_rate(0) == near_relative(135, 1e-12));
  // Contraction -sin(psi) / cos(psi): the principal rates are turned by psi / 2.
  CHECK(major_direction_of_rate(-std::tan(20 * degree)) == near_relative(145, 1e-12));
}

TEST_CASE("broken is the mass in pieces, detached that without the largest piece of each") {
  Particles particles(0.01, 2500);
  particles.add(rectangle({0, 0}, 2, 1), Motion::free);
  particles.add(rectangle({5, 0}, 1, 1), Motion::free);
  particles.add(rectangle({9, 0}, 5, 5), Motion::wall);
  CHECK(broken_mass(particles).broken == 0);
  // 2 m^2 into 1.5 and 0.5, and the 0.5 into two halves.
  const Ancestry first = particles.ancestry(0);
  particles.replace(0, rectangle({-0.25, 0}, 1.5, 1), Motion::free, first);
  const BodyIndex rest = particles.add(rectangle({0.75, 0}, 0.5, 1), Motion::free, &first);
  CHECK(broken_mass(particles).broken == near_relative(2.0 / 3, 1e-12));
  CHECK(broken_mass(particles).detached == near_relative(0.5 / 3, 1e-12));
  const Ancestry second = particles.ancestry(rest);
  particles.replace(rest, rectangle({0.625, 0}, 0.25, 1), Motion::free, second);
  particles.add(rectangle({0.875, 0}, 0.25, 1), Motion::free, &second);
  CHECK(broken_mass(particles).broken == near_relative(2.0 / 3, 1e-12));
  CHECK(broken_mass(particles).detached == near_relative(0.5 / 3, 1e-12));
}

TEST_CASE("the shear rate is that of the inertial number") {
  Options o;
  o.assembly.mean_diameter = 0.01;
  o.inertial_number = 2e-3;
  // I = rate d sqrt(rho / p) with d = 0.01 m, rho = 2500 kg/m^3, p = 1 MPa.
  CHECK(o.rate(1e6) == near_relative(2e-3 / (0.01 * 0.05), 1e-12));
  o.normal_stresses = {1e6, -1};
  o.shear = 0.1;
  CHECK_THROWS_WITH_AS(o.validate(), "--normal-stresses = -1: must be a finite number above 0",
                       InvalidInput);
}
