// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/line_fit/mean_stress_failure_plane.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <support/loaded_disc.hpp>
#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

// A parallelogram with a long diagonal, under two opposed forces along axis 2.
internal::LoadedSample leaning(double lean, double stress) {
  internal::LoadedSample sample{
      ConvexPolygon{
          {-0.01 - lean, -0.01}, {0.01 - lean, -0.01}, {0.01 + lean, 0.01}, {-0.01 + lean, 0.01}},
      0.01,
      {}};
  const double force = stress * 0.02 * 0.01;
  sample.loads = {{.arm_lab = {0, 0.01}, .force_lab = {0, -force}},
                  {.arm_lab = {0, -0.01}, .force_lab = {0, force}}};
  return sample;
}

}  // namespace

TEST_CASE("in shear the line is the failure plane with the shorter cut") {
  const HoekBrown criterion;
  const double stress = 1.01 * criterion.major_stress_at_failure(0);
  const double off = 0.25 * pi - 0.5 * criterion.friction_angle(0);
  for (const double side : {1.0, -1.0}) {
    const auto line = ask(MeanStressFailurePlane{}, leaning(0.009 * side, stress));
    REQUIRE(line);
    CHECK(line->point.norm() < 1e-16);
    // Towards the short diagonal: it leaves by a side, the other one by top and bottom.
    const Vec2 expected{-side * std::sin(off), std::cos(off)};
    CHECK(std::abs(cross(line->direction, expected)) < 1e-12);
  }
}

TEST_CASE("of equal cuts it is either, along a failure plane") {
  const HoekBrown criterion;
  const double stress = 1.01 * criterion.major_stress_at_failure(0);
  const double off = 0.25 * pi - 0.5 * criterion.friction_angle(0);
  const auto line = ask(MeanStressFailurePlane{}, leaning(0, stress));
  REQUIRE(line);
  CHECK(std::abs(line->direction.x()) == near_relative(std::sin(off), 1e-12));
}

TEST_CASE("else it runs along the major stress, and nowhere where there is no deviator") {
  const auto line = ask(MeanStressFailurePlane{}, leaning(0.004, 1e6));
  REQUIRE(line);
  CHECK(std::abs(line->direction.x()) < 1e-12);
  CHECK_FALSE(ask(MeanStressFailurePlane{}, leaning(0.004, 0)));
}
