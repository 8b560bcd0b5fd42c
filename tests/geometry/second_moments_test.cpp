// SPDX-License-Identifier: BSL-1.0
#include <riprap/geometry/second_moments.hpp>

#include <doctest/doctest.h>

#include <riprap/geometry/polygon_properties.hpp>
#include <support/near.hpp>
#include <support/polygons.hpp>

using namespace riprap;
using namespace riprap::test;

TEST_CASE("a rectangle has b h^3 / 12, turned by an angle a moment xy as well") {
  const ConvexPolygon flat = rectangle(0.3, 0.1);
  const double large = 0.1 * 0.3 * 0.3 * 0.3 / 12;
  const double small = 0.3 * 0.1 * 0.1 * 0.1 / 12;
  for (const double angle : {0.0, 0.4, 1.3, -2.0}) {
    const ConvexPolygon turned = flat.moved(Rotation::from_angle(angle), {0, 0});
    const SecondMoments m = second_moments(turned.ring(), {0, 0});
    const double c = std::cos(2 * angle);
    const double s = std::sin(2 * angle);
    const double tolerance = 1e-14 * large;
    CHECK(m.xx == near(0.5 * (large + small) + 0.5 * (large - small) * c, tolerance));
    CHECK(m.yy == near(0.5 * (large + small) - 0.5 * (large - small) * c, tolerance));
    CHECK(m.xy == near(0.5 * (large - small) * s, tolerance));
  }
}

TEST_CASE("about the centroid their sum is the polar moment, about other points there is Steiner") {
  const ConvexPolygon polygon{{0, 0}, {0.02, -0.004}, {0.025, 0.01}, {0.01, 0.02}};
  const AreaProperties p = area_properties(polygon.ring());
  const SecondMoments m = second_moments(polygon.ring(), p.centroid);
  CHECK(m.xx + m.yy == near_relative(p.polar_moment, 1e-13));
  const Vec2 d{0.03, -0.05};
  const SecondMoments other = second_moments(polygon.ring(), p.centroid - d);
  CHECK(other.xx == near_relative(m.xx + p.area * d.x() * d.x(), 1e-13));
  CHECK(other.yy == near_relative(m.yy + p.area * d.y() * d.y(), 1e-13));
  CHECK(other.xy == near_relative(m.xy + p.area * d.x() * d.y(), 1e-13));
}
