// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/line_fit/failure_plane_through_centroid.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <support/near.hpp>
#include <support/point_clouds.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

FailurePlanes planes_at(std::initializer_list<double> angles) {
  FailurePlanes planes;
  for (const double angle : angles)
    planes.directions[planes.count++] = Vec2{std::cos(angle), std::sin(angle)};
  return planes;
}

double misfit(const Cloud& cloud, const Line& line) {
  double sum = 0;
  for (const WeightedPoint& p : cloud) {
    const double d = line.left_distance(p.position);
    sum += p.weight * d * d;
  }
  return sum;
}

}  // namespace

TEST_CASE("a single failure plane gives the direction, the points the place") {
  const auto line = FailurePlaneThroughCentroid{}(three_points(), planes_at({0.3}));
  REQUIRE(line);
  CHECK(line->direction == Vec2{std::cos(0.3), std::sin(0.3)});
  CHECK((line->point - Vec2{10.0 / 7, 2}).norm() == near(0, 1e-15));
}

TEST_CASE("of two shear planes the one closer to the points is taken") {
  for (const Cloud& cloud : {three_points(), scattered_points()})
    for (const double p : {-1.2, -0.4, 0.5, 1.4})
      for (const double q : {-0.9, 0.1, 0.8, 1.1}) {
        const auto line = FailurePlaneThroughCentroid{}(cloud, planes_at({p, q}));
        REQUIRE(line);
        const Line by_p{line->point, {std::cos(p), std::sin(p)}};
        const Line by_q{line->point, {std::cos(q), std::sin(q)}};
        CHECK(misfit(cloud, *line) == std::min(misfit(cloud, by_p), misfit(cloud, by_q)));
      }
}

TEST_CASE("the line turns with the particle") {
  const auto line = FailurePlaneThroughCentroid{}(scattered_points(), planes_at({0.2, 1.3}));
  for (const double angle : {0.4, 1.9, -2.7}) {
    const Rotation turn = Rotation::from_angle(angle);
    const auto rotate = [&](const Vec2& p) { return Vec2(turn * p); };
    const auto image = FailurePlaneThroughCentroid{}(mapped(scattered_points(), rotate),
                                                     planes_at({0.2 + angle, 1.3 + angle}));
    REQUIRE(image);
    CHECK(off_angle(image->direction, turn * line->direction) == near(0, 1e-14));
    CHECK(image->left_distance(turn * line->point) == near(0, 1e-14));
  }
}

TEST_CASE("one failed element is enough, none or no plane is not") {
  const auto line = FailurePlaneThroughCentroid{}(Cloud{{{3, 4}, 2}}, planes_at({0.7, -0.7}));
  REQUIRE(line);
  CHECK(line->point == Vec2{3, 4});
  CHECK_FALSE(FailurePlaneThroughCentroid{}(Cloud{}, planes_at({0.7})));
  CHECK_FALSE(FailurePlaneThroughCentroid{}(three_points(), FailurePlanes{}));
}
