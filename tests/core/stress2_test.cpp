// SPDX-License-Identifier: BSL-1.0
#include <riprap/core/stress2.hpp>

#include <Eigen/Core>
#include <doctest/doctest.h>
#include <numbers>
#include <vector>

#include <support/near.hpp>

using namespace riprap;
using test::near_relative;

namespace {

Eigen::Matrix2d matrix(const Stress2& s) {
  Eigen::Matrix2d m;
  m << s.s11, s.s12, s.s12, s.s22;
  return m;
}

/// sigma = major n n^T + minor m m^T with n at `angle` and m across it.
Stress2 from_principal(double major, double minor, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {major * c * c + minor * s * s, major * s * s + minor * c * c, (major - minor) * c * s};
}

void check_is_principal(const Stress2& stress, const PrincipalStress& p) {
  const double size = matrix(stress).norm();
  CHECK(p.major >= p.minor);
  CHECK(std::abs(p.major_direction.norm() - 1) <= 4e-16);
  // Residual of the eigenvalue equation: a few roundings of the largest component.
  const Vec2 n = p.major_direction;
  CHECK((matrix(stress) * n - p.major * n).norm() <= 4e-16 * size);
  const Vec2 m = perpendicular(n);
  CHECK((matrix(stress) * m - p.minor * m).norm() <= 4e-16 * size);
}

const std::vector<double> values = {-300e6, -12e6, -1, 0, 1, 12e6, 300e6};

}  // namespace

TEST_CASE("principal stresses solve the eigenvalue equation for every order and sign") {
  for (const double s11 : values)
    for (const double s22 : values)
      for (const double s12 : values) {
        CAPTURE(s11);
        CAPTURE(s22);
        CAPTURE(s12);
        const Stress2 stress{s11, s22, s12};
        check_is_principal(stress, stress.principal());
      }
}

TEST_CASE("stress along the axes has them as principal directions, whichever is larger") {
  const PrincipalStress first = Stress2{5, 2, 0}.principal();
  CHECK(first.major == 5);
  CHECK(first.minor == 2);
  CHECK(std::abs(first.major_direction.x()) == 1);
  const PrincipalStress second = Stress2{-7, -3, 0}.principal();
  CHECK(second.major == -3);
  CHECK(second.minor == -7);
  CHECK(std::abs(second.major_direction.y()) == 1);
}

TEST_CASE("pure shear compresses along the diagonal of its sign") {
  const PrincipalStress positive = Stress2{0, 0, 4}.principal();
  CHECK(positive.major == 4);
  CHECK(positive.minor == -4);
  CHECK(positive.major_direction.x() * positive.major_direction.y() == near_relative(0.5, 1e-15));
  const PrincipalStress negative = Stress2{0, 0, -4}.principal();
  CHECK(negative.major == 4);
  CHECK(negative.minor == -4);
  CHECK(negative.major_direction.x() * negative.major_direction.y() == near_relative(-0.5, 1e-15));
}

TEST_CASE("the major direction is found at every angle, also for nearly equal principal values") {
  for (const double minor : {-20e6, 0.0, 9.99e6}) {
    for (int degrees = -180; degrees <= 180; ++degrees) {
      const double angle = degrees * std::numbers::pi / 180;
      const PrincipalStress p = from_principal(10e6, minor, angle).principal();
      // Round-off of the components; it turns the direction by its ratio to the difference.
      const double size = std::max(10e6, std::abs(minor));
      const double error = 8e-16 * size;
      CHECK(std::abs(p.major - 10e6) <= error);
      CHECK(std::abs(p.minor - minor) <= error);
      const Vec2 expected{std::cos(angle), std::sin(angle)};
      CHECK(std::abs(cross(p.major_direction, expected)) <= error / (10e6 - minor) + 4e-16);
    }
  }
}

TEST_CASE("an isotropic stress has every direction as principal, and names a unit vector") {
  for (const double pressure : {-3e6, 0.0, 5e6}) {
    const PrincipalStress p = Stress2{pressure, pressure, 0}.principal();
    CHECK(p.major == pressure);
    CHECK(p.minor == pressure);
    CHECK(p.major_direction.norm() == 1);
  }
}

TEST_CASE("mean and radius are centre and radius of Mohr's circle") {
  const Stress2 stress{8, 2, 4};
  CHECK(stress.mean() == 5);
  CHECK(stress.radius() == 5);
  CHECK(stress.principal().major == 10);
  CHECK(stress.principal().minor == 0);
}

TEST_CASE("a turned stress is R sigma R^T") {
  for (const Stress2& stress : {Stress2{3, -1, 2}, Stress2{-50e6, 12e6, 7e6}, Stress2{0, 0, 1}})
    for (const double angle : {0.0, 0.3, 1.9, -2.7, std::numbers::pi / 2}) {
      const Rotation r = Rotation::from_angle(angle);
      Eigen::Matrix2d turn;
      turn << r.cosine, -r.sine, r.sine, r.cosine;
      const Eigen::Matrix2d expected = turn * matrix(stress) * turn.transpose();
      // Three products of rounded factors.
      CHECK((matrix(stress.rotated(r)) - expected).norm() <= 1e-15 * matrix(stress).norm());
    }
}

TEST_CASE("a body under compression along its own axis 1 is compressed where that axis points") {
  const Rotation body = Rotation::from_angle(30 * std::numbers::pi / 180);
  const Stress2 laboratory = Stress2{10, 0, 0}.rotated(body);
  CHECK(laboratory.s11 == near_relative(7.5, 1e-15));
  CHECK(laboratory.s22 == near_relative(2.5, 1e-15));
  CHECK(laboratory.s12 == near_relative(10 * std::sqrt(3.0) / 4, 1e-15));
  const Vec2 direction = laboratory.principal().major_direction;
  CHECK(std::abs(cross(direction, body * Vec2{1, 0})) <= 1e-15);
}

TEST_CASE("turning leaves the principal stresses and turns their direction along") {
  const Stress2 stress{40e6, -9e6, 13e6};
  const PrincipalStress before = stress.principal();
  for (int degrees = 0; degrees < 360; degrees += 7) {
    const Rotation r = Rotation::from_angle(degrees * std::numbers::pi / 180);
    const PrincipalStress after = stress.rotated(r).principal();
    CHECK(std::abs(after.major - before.major) <= 1e-15 * 50e6);
    CHECK(std::abs(after.minor - before.minor) <= 1e-15 * 50e6);
    CHECK(std::abs(cross(after.major_direction, r * before.major_direction)) <= 2e-15);
  }
}

TEST_CASE("stresses add up and scale component by component") {
  Stress2 sum{1, 2, 3};
  sum += Stress2{10, 20, 30};
  CHECK(sum.s11 == 11);
  CHECK(sum.s22 == 22);
  CHECK(sum.s12 == 33);
  const Stress2 half = 0.5 * sum;
  CHECK(half.s11 == 5.5);
  CHECK(half.s22 == 11);
  CHECK(half.s12 == 16.5);
}

TEST_CASE("a minor stress that is small beside the major one keeps its digits") {
  for (const double minor : {-1845.0, -1.0, -1e-6, 0.0, 1e-9, 1845.0})
    for (const bool swapped : {false, true}) {
      CAPTURE(minor);
      const double major = 3.86e7;
      const Stress2 aligned = swapped ? Stress2{minor, major, 0} : Stress2{major, minor, 0};
      CHECK(aligned.principal_values().minor == minor);
      CHECK(aligned.principal_values().major == major);
      CHECK(aligned.principal().minor == minor);
      // In other axes the components carry the stresses to a rounding of the major one.
      for (const double angle : {1e-8, 1e-3, 0.4, 0.785, 1.3}) {
        const PrincipalValues principal = from_principal(major, minor, angle).principal_values();
        CHECK(std::abs(principal.minor - minor) <= 1e-14 * major);
        CHECK(std::abs(principal.major - major) <= 1e-14 * major);
      }
    }
  // From 500 digits: mean -+ radius of (3.86e7, -1845, 12).
  const PrincipalValues principal = Stress2{3.86e7, -1845, 12}.principal_values();
  CHECK(principal.minor == near_relative(-1845.00000373039164, 1e-15));
}
