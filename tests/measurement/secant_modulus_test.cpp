// SPDX-License-Identifier: BSL-1.0
#include <riprap/measurement/secant_modulus.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::message_of;
using test::near_relative;

namespace {

// A few operations.
constexpr double round_off = 1e-14;

// Rises to 8 MPa by way of 3 and 6, then softens.
const std::vector<Vec2> curve{{0, 0}, {0.01, 3e6}, {0.02, 6e6}, {0.06, 8e6}, {0.2, 5e6}};

/// Duncan and Chang's hyperbola with an initial slope of 100 MPa and an asymptote of 10 MPa.
std::vector<Vec2> hyperbola(int points, double end) {
  std::vector<Vec2> out;
  for (int i = 0; i <= points; ++i) {
    const double strain = end * i / points;
    out.push_back({strain, strain / (1 / 100e6 + strain / 10e6)});
  }
  return out;
}

std::vector<Vec2> shifted(std::vector<Vec2> points, const Vec2& by) {
  for (Vec2& p : points) p += by;
  return points;
}

}  // namespace

TEST_CASE("E_50 is read where the curve first reaches half its peak") {
  // 4 MPa are reached a third of the way from 3 to 6.
  const SecantModulus m = secant_modulus_at_share(curve);
  CHECK(m.deviator == near_relative(4e6, round_off));
  CHECK(m.axial_strain == near_relative(0.04 / 3, round_off));
  CHECK(m.modulus == near_relative(300e6, round_off));
  // At the peak itself, and not at the same stress after it.
  CHECK(secant_modulus_at_share(curve, 1).axial_strain == near_relative(0.06, round_off));
  CHECK(secant_modulus_at_share(curve, 0.9).axial_strain == near_relative(0.044, round_off));
}

TEST_CASE("the modulus at a strain is the slope to the curve there") {
  CHECK(secant_modulus_at_strain(curve, 0.01).modulus == near_relative(300e6, round_off));
  CHECK(secant_modulus_at_strain(curve, 0.04).deviator == near_relative(7e6, round_off));
  CHECK(secant_modulus_at_strain(curve, 0.04).modulus == near_relative(175e6, round_off));
  CHECK(secant_modulus_at_strain(curve, 0.2).modulus == near_relative(25e6, round_off));
}

TEST_CASE("a hyperbola has its secant moduli in closed form") {
  const std::vector<Vec2> points = hyperbola(20000, 0.2);
  // At a strain e: 1 / (1/E + e/q). The peak is q e_end / (q/E + e_end) = 20/3 MPa; to half of it,
  // q/3, the slope is E (1 - 1/3). Chords of 1e-5 are below the curve by e^2 / 8 times its bend,
  // 2 E^2 / q: 2.5e-9 of E and less of q, within 1e-6 of the deviators here.
  CHECK(secant_modulus_at_strain(points, 0.05).modulus == near_relative(100e6 / 1.5, 1e-6));
  CHECK(secant_modulus_at_share(points).modulus == near_relative(100e6 * 2 / 3, 1e-6));
}

TEST_CASE("both count from the first point and have the unit of stress") {
  const std::vector<Vec2> later = shifted(curve, {0.003, 0.25e6});
  CHECK(secant_modulus_at_share(later).modulus ==
        near_relative(secant_modulus_at_share(curve).modulus, 10 * round_off));
  CHECK(secant_modulus_at_strain(later, 0.04).modulus ==
        near_relative(secant_modulus_at_strain(curve, 0.04).modulus, 10 * round_off));
  std::vector<Vec2> in_megapascal = curve;
  for (Vec2& p : in_megapascal) p.y() *= 1e-6;
  CHECK(secant_modulus_at_share(in_megapascal).modulus == near_relative(300, round_off));
}

TEST_CASE("curves without a modulus are refused") {
  const auto at_half = [](const std::vector<Vec2>& points) {
    return message_of([&] { (void)secant_modulus_at_share(points); });
  };
  CHECK(at_half({{0, 0}}) == "secant modulus: number of points = 1: must be 2 or more");
  CHECK(at_half({{0, 0}, {0.1, 1}, {0.1, 2}}) == "axial strain = 0.1: must ascend");
  CHECK(at_half({{0, 5}, {0.1, 4}, {0.2, 5}}) ==
        "secant modulus: rise of the deviator = 0: must be a finite number above 0");
  CHECK(message_of([] { (void)secant_modulus_at_share(curve, 0); }) ==
        "share of the largest deviator = 0: must lie in (0, 1]");
  for (const double strain : {0.0, 0.21})
    CHECK(test::contains(message_of([&] { (void)secant_modulus_at_strain(curve, strain); }),
                         "must lie above 0 and on the curve"));
}
