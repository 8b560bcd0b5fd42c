// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/line_fit/weighted_xy_by_mean_stress.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include <support/message_of.hpp>
#include <support/near.hpp>
#include <support/point_clouds.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

std::optional<Line> fit(const Cloud& cloud, const Stress2& mean, const FailurePlanes& planes = {}) {
  return WeightedXYByMeanStress{}(cloud, planes, mean);
}

// Tension along axis 1 of a frame turned by `angle`, under twice the compression across it.
Stress2 tension_at(double angle) { return Stress2{-1, 2, 0}.rotated(Rotation::from_angle(angle)); }

}  // namespace

TEST_CASE("the mean stress chooses between the X and the Y line, the failure planes do not") {
  const Cloud cloud = three_points();
  const Vec2 x = WeightedX{}(cloud, {})->direction;
  const Vec2 y = WeightedY{}(cloud, {})->direction;
  // Tension across a line chooses it.
  const double across_x = std::atan2(-x.x(), x.y());
  const double across_y = std::atan2(-y.x(), y.y());
  FailurePlanes planes;
  planes.count = 1;
  for (const Vec2& plane : {x, y}) {
    planes.directions[0] = plane;
    for (const double scale : {1.0, 1e6, 1e-6}) {
      CHECK(fit(cloud, scale * tension_at(across_x), planes)->direction == x);
      CHECK(fit(cloud, scale * tension_at(across_y), planes)->direction == y);
    }
  }
}

TEST_CASE("the choice changes where the plane across the tension halves the angle between both") {
  const Cloud cloud = scattered_points();
  const Vec2 x = WeightedX{}(cloud, {})->direction;
  const Vec2 y = WeightedY{}(cloud, {})->direction;
  const double apart = std::atan2(cross(y, x), y.dot(x));
  const double middle = std::atan2(y.y(), y.x()) + 0.5 * apart;  // of the plane
  const double towards_x = apart > 0 ? 1e-6 : -1e-6;
  const double across = 0.5 * std::numbers::pi;
  CHECK(fit(cloud, tension_at(middle + towards_x + across))->direction == x);
  CHECK(fit(cloud, tension_at(middle - towards_x + across))->direction == y);
}

TEST_CASE("compression all round chooses by its least") {
  const Cloud cloud = three_points();
  const Vec2 x = WeightedX{}(cloud, {})->direction;
  Stress2 mean = tension_at(std::atan2(-x.x(), x.y()));
  mean += Stress2{50, 50, 0};
  CHECK(fit(cloud, mean)->direction == x);
}

TEST_CASE("without a deviator, and where both are equally near, the Y line is taken") {
  const Cloud cloud = three_points();
  const Vec2 y = WeightedY{}(cloud, {})->direction;
  CHECK(fit(cloud, {})->direction == y);
  CHECK(fit(cloud, {3, 3, 0})->direction == y);
  // Round-off of the sum over the elements is no direction.
  CHECK(fit(cloud, {3e6, 3e6 + 1e-9, 1e-9})->direction == y);
  // Symmetric about the diagonal, across which the tension acts.
  const Cloud square{{{0, 0}, 1}, {{4, 4}, 1}, {{1, 3}, 1}, {{3, 1}, 1}};
  CHECK(fit(square, {0, 0, 1})->direction == WeightedY{}(square, {})->direction);
}

TEST_CASE("where one of the two lines does not exist the other is taken") {
  const Cloud vertical{{{2, 0}, 1}, {{2, 1}, 1}};
  for (const double angle : {0.0, 1.5}) {
    CHECK(off_angle(fit(vertical, tension_at(angle))->direction, {0, 1}) == 0);
    CHECK_FALSE(fit(Cloud{{{1, 1}, 1}}, tension_at(angle)));
    CHECK_FALSE(fit(Cloud{}, tension_at(angle)));
  }
}

TEST_CASE("turned by 90 degrees with the mean stress the cloud carries the chosen line along") {
  for (const double angle : {0.2, 0.9, 1.6, 2.7}) {
    const auto line = fit(scattered_points(), tension_at(angle));
    const auto turned =
        fit(mapped(scattered_points(), perpendicular), tension_at(angle + 0.5 * std::numbers::pi));
    CHECK(off_angle(turned->direction, perpendicular(line->direction)) == near(0, 1e-14));
  }
}

TEST_CASE("a mean stress that is not finite is refused") {
  const double infinite = std::numeric_limits<double>::infinity();
  for (const Stress2& mean : {Stress2{infinite, 0, 0}, Stress2{0, 0, std::nan("")}})
    CHECK(contains(message_of([&] { (void)fit(three_points(), mean); }),
                   "line fit: mean stress of the particle"));
}
