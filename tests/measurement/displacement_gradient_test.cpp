// SPDX-License-Identifier: BSL-1.0
#include <riprap/measurement/displacement_gradient.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>

#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

/// F - I of stretches l and m along axes turned by `axis`, followed by a rotation.
DisplacementGradient stretched(double l, double m, double axis, double rotation) {
  const double c = std::cos(axis);
  const double s = std::sin(axis);
  const double u11 = l * c * c + m * s * s;
  const double u22 = l * s * s + m * c * c;
  const double u12 = (l - m) * c * s;
  const double cr = std::cos(rotation);
  const double sr = std::sin(rotation);
  return {cr * u11 - sr * u12 - 1, cr * u12 - sr * u22, sr * u11 + cr * u12,
          sr * u12 + cr * u22 - 1};
}

}  // namespace

TEST_CASE("stretches and a rotation after them are found, whatever their axes") {
  for (const double axis : {0.0, 0.4, -1.1})
    for (const double rotation : {0.0, 0.3, -2.0, 3.0}) {
      const DisplacementGradient h = stretched(1.1, 0.8, axis, rotation);
      CHECK(h.volumetric_strain() == near(1 - 1.1 * 0.8, 1e-15));
      CHECK(h.deviatoric_strain() == near(0.3, 1e-15));
      CHECK(h.rotation() == near(rotation, 1e-15));
    }
}

TEST_CASE("contraction is positive, and a rigid rotation is no strain") {
  CHECK(DisplacementGradient{-0.1, 0, 0, -0.1}.volumetric_strain() == near(0.19, 1e-15));
  const DisplacementGradient h = stretched(1, 1, 0, std::numbers::pi / 3);
  CHECK(h.volumetric_strain() == near(0, 1e-15));
  CHECK(h.deviatoric_strain() == near(0, 1e-15));
}

TEST_CASE("of simple shear the deviatoric strain is the engineering one, its rotation half of it") {
  // u_1 = 1e-4 x_2: clockwise. The angle is atan(gamma / 2).
  const DisplacementGradient h{0, 1e-4, 0, 0};
  CHECK(h.deviatoric_strain() == 1e-4);
  CHECK(h.volumetric_strain() == 0);
  CHECK(h.rotation() == near_relative(-std::atan(0.5e-4), 1e-15));
}

TEST_CASE("the gradient of an affine displacement is found from any three points") {
  const DisplacementGradient h{0.01, -0.2, 0.07, -0.03};
  const auto field = [&](const Vec2& x) -> Vec2 {
    return {5 + h.h11 * x.x() + h.h12 * x.y(), -3 + h.h21 * x.x() + h.h22 * x.y()};
  };
  const std::array<Vec2, 3> x{Vec2{0.2, 0.1}, Vec2{1.4, 0.3}, Vec2{0.5, 1.1}};
  const DisplacementGradient found =
      displacement_gradient(x, {field(x[0]), field(x[1]), field(x[2])});
  // Round-off of displacements of 5 m over distances of 1 m.
  CHECK(found.h11 == near(h.h11, 1e-14));
  CHECK(found.h12 == near(h.h12, 1e-14));
  CHECK(found.h21 == near(h.h21, 1e-14));
  CHECK(found.h22 == near(h.h22, 1e-14));
}
