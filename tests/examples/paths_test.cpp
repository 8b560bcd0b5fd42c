// SPDX-License-Identifier: BSL-1.0
#include <paths/measures.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace paths;
using riprap::CurvePoint;
using riprap::Vec2;
using riprap::test::message_of;
using riprap::test::near;
using riprap::test::near_relative;

namespace {

// Lengths over those at zero strain.
CurvePoint strained(double length_1, double length_2, double s11, double s22) {
  CurvePoint p;
  p.axial_strain = 1 - length_2;
  p.volumetric_strain = 1 - length_1 * length_2;
  p.stress = {.s11 = s11, .s22 = s22};
  return p;
}

CurvePoint of_stage(std::size_t stage, double axial_strain) {
  CurvePoint p;
  p.stage_index = stage;
  p.axial_strain = axial_strain;
  return p;
}

}  // namespace

TEST_CASE("the area of an ellipse of stress against strain is pi times its semi-axes") {
  // As a viscoelastic sample describes it under cyclic strain: clockwise. A polygon of n corners
  // has a share of 2 pi^2 / (3 n^2) less.
  constexpr int corners = 1000;
  constexpr double strain = 0.002;
  constexpr double stress = 3e5;
  std::vector<Vec2> loop;
  for (int k = 0; k < corners; ++k) {
    const double t = 2 * std::numbers::pi * k / corners;
    loop.push_back({0.01 + strain * std::sin(t), 1e6 + stress * std::cos(t)});
  }
  CHECK(loop_area(loop) == near_relative(std::numbers::pi * strain * stress, 1e-5));
  CHECK(loop_area(std::vector<Vec2>(loop.rbegin(), loop.rend())) ==
        near_relative(-std::numbers::pi * strain * stress, 1e-5));
}

TEST_CASE("there and back on one line encloses nothing") {
  CHECK(loop_area(std::vector<Vec2>{{0, 0}, {0.001, 1e6}, {0.002, 2e6}, {0.001, 1e6}}) ==
        near(0, 1e-9));
}

TEST_CASE("a pressure does the work of the volume that it takes") {
  // p (V_0 - V) / V_0, however the sides change; the error of the trapezoid goes with the square of
  // the increments, here (0.3 / 1000)^2 / 12.
  std::vector<CurvePoint> points;
  for (int k = 0; k <= 1000; ++k) {
    const double t = k / 1000.0;
    points.push_back(strained(1 + 0.1 * t, 1 - 0.3 * t * t, 2e6, 2e6));
  }
  CHECK(stress_work(points) == near_relative(2e6 * (1 - 1.1 * 0.7), 1e-5));
}

TEST_CASE("the work of a constant force is force times path") {
  // Side 1 keeps its length; sigma_22 times it is the force on side 2.
  std::vector<CurvePoint> points;
  for (int k = 0; k <= 1000; ++k) points.push_back(strained(1, 1 - 0.0002 * k, 1e6, 5e6));
  CHECK(stress_work(points) == near_relative(5e6 * 0.2, 1e-6));
  // On the way back the sample does it.
  CHECK(stress_work({points.rbegin(), points.rend()}) == near_relative(-5e6 * 0.2, 1e-6));
}

TEST_CASE("a stage has its points and the end of the one before") {
  const Points curve{of_stage(3, 0), of_stage(3, 0.1), of_stage(4, 0.2), of_stage(4, 0.3),
                     of_stage(6, 0.4)};
  const Points first = stage_points(curve, 3);
  REQUIRE(first.size() == 2);
  CHECK(first.front().axial_strain == 0);
  const Points second = stage_points(curve, 4);
  REQUIRE(second.size() == 3);
  CHECK(second.front().axial_strain == 0.1);
  CHECK(stage_end(curve, 4).axial_strain == 0.3);
  CHECK(stage_points(curve, 5).empty());
  CHECK(message_of([&] { (void)stage_end(curve, 5); }) == "stage_end: stage = 5: must have points");
}

TEST_CASE("a secant is a rise over a run") {
  CHECK(secant({0.001, 1e6}, {0.003, 5e6}) == near_relative(2e9, 1e-12));
  CHECK(secant({0.003, 5e6}, {0.001, 1e6}) == near_relative(2e9, 1e-12));
}
