// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/line_fit/mean_tension_line.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include <riprap/breakage/crack.hpp>
#include <riprap/breakage/criterion/hoek_brown.hpp>
#include <riprap/core/units.hpp>
#include <riprap/stress/mesher/fan_mesher.hpp>
#include <riprap/stress/mesher/uniform_mesher.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>
#include <support/point_clouds.hpp>
#include <support/polygons.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

std::optional<Line> fit(const Cloud& cloud) { return MeanTensionLine{}(cloud, FailurePlanes{}); }

Vec2 at(double angle) { return {std::cos(angle), std::sin(angle)}; }

// Principal stress `along` in the direction of `angle`, `across` across it.
Stress2 principal(double along, double across, double angle) {
  return Stress2{along, across, 0}.rotated(Rotation::from_angle(angle));
}

WeightedPoint torn(const Vec2& position, double area, double angle, double tension = 20_MPa) {
  return {position, 1, area, principal(-tension, 0, angle)};
}

// Each triangle in four like it, whose stress it keeps, where `refine(centroid)`.
template <class Refine>
Cloud refined(const Mesh& mesh, const Cloud& coarse, const Refine& refine) {
  Cloud out;
  for (std::size_t e = 0; e < mesh.size(); ++e) {
    const Vec2 middle = mesh.centroid(e);
    if (!refine(middle)) {
      out.push_back(coarse[e]);
      continue;
    }
    WeightedPoint part = coarse[e];
    part.area /= 4;
    out.push_back(part);  // the inner one, with the same centroid
    for (const Vec2& corner : mesh.triangle(e)) {
      part.position = 0.5 * (middle + corner);
      out.push_back(part);
    }
  }
  return out;
}

}  // namespace

TEST_CASE("under uniform tension the line runs across it, on any mesh, in any pose") {
  const ConvexPolygon polygon{{-3, -1}, {2, -2}, {4, 1}, {0, 2}};
  const auto check = [](const Mesh& mesh, double angle, double turn) {
    ElementStress stress;
    stress.reset(mesh.size());
    for (std::size_t e = 0; e < mesh.size(); ++e) stress.set(e, principal(-20_MPa, 0, angle));
    Body body;
    body.rotation = Rotation::from_angle(turn);
    body.position = {30, -20};
    const auto line = fit(failed_points(HoekBrown{}, SamplingPoints(mesh), stress, body));
    REQUIRE(line);
    CHECK(line->direction.norm() == near(1, 1e-15));
    // Half of the angle of a vector that is rounded in its last digits.
    CHECK(off_angle(line->direction, body.rotation * at(angle + pi / 2)) == near(0, 1e-14));
    // The centroid, rounded as coordinates of 40 are.
    CHECK((line->point - body.position).norm() == near(0, 1e-13));
  };
  const ConvexPolygon centred = shifted(polygon, -area_properties(polygon.ring()).centroid);
  for (int k = 0; k < 36; ++k) {
    const double angle = 5_deg * k;
    CAPTURE(angle);
    check(FanMesher{}(centred.ring()), angle, 0.4);
    for (const unsigned triangles : {20u, 100u, 300u})
      check(UniformMesher{triangles}(centred.ring()), angle, -1.3 * k);
  }
}

TEST_CASE("the size of the stress and 1/SF play no part, the area does") {
  // Dyads of the crack directions 0 and 60 degrees with the areas 3 and 1: the doubled angles 0 and
  // 120 degrees add up to (3 - 1/2, sqrt(3)/2).
  Cloud cloud{torn({0, 0}, 3, pi / 2), torn({4, 8}, 1, 150_deg)};
  const auto line = fit(cloud);
  REQUIRE(line);
  const double angle = 0.5 * std::atan2(std::sqrt(0.75), 2.5);
  CHECK(off_angle(line->direction, at(angle)) == near(0, 1e-15));
  CHECK((line->point - Vec2{1, 2}).norm() == near(0, 1e-15));
  cloud[0].weight = 50;
  cloud[1].stress = 100 * cloud[1].stress;
  CHECK(off_angle(fit(cloud)->direction, line->direction) == near(0, 1e-15));
  CHECK(fit(cloud)->point == line->point);
  cloud[0].stress.s11 -= 5_MPa;  // all round: the directions are the same
  cloud[0].stress.s22 -= 5_MPa;
  CHECK(off_angle(fit(cloud)->direction, line->direction) == near(0, 1e-15));
}

TEST_CASE("without tension the line runs between the shear planes") {
  const HoekBrown rock;
  for (const double angle : {0.0, 0.3, 1.2, 2.9}) {
    const Stress2 pressed = principal(900_MPa, 10_MPa, angle);
    const ElementFailure failure = evaluate(rock, pressed);
    REQUIRE(failure.mode == FailureMode::shear);
    const auto line = fit({{{1, 2}, failure.weight(), 0.1, pressed}});
    REQUIRE(line);
    CHECK(off_angle(line->direction, at(angle)) == near(0, 1e-14));
    const FailurePlanes planes = failure_planes(rock, pressed, failure.mode);
    CHECK(off_angle(line->direction, planes.directions[0]) ==
          near(off_angle(line->direction, planes.directions[1]), 1e-14));
  }
}

TEST_CASE("refining one half of a mesh does not turn the line") {
  const Mesh mesh = UniformMesher{100}(regular_polygon(7, 1).ring());
  // Another tension on either side.
  Cloud coarse;
  for (std::size_t e = 0; e < mesh.size(); ++e)
    coarse.push_back(torn(mesh.centroid(e), mesh.area(e), mesh.centroid(e).x() < 0 ? 0.2 : 1.1));
  const Cloud fine = refined(mesh, coarse, [](const Vec2& x) { return x.x() < 0; });
  REQUIRE(fine.size() > 2 * coarse.size());
  const auto expected = fit(coarse);
  const auto line = fit(fine);
  REQUIRE(expected);
  REQUIRE(line);
  CHECK(off_angle(line->direction, expected->direction) == near(0, 1e-14));
  CHECK((line->point - expected->point).norm() == near(0, 1e-14));
  // Counted instead, the refined half would turn it by a large part of the 0.9 between them.
  Cloud counted = fine;
  for (WeightedPoint& p : counted) p.area = 1;
  CHECK(off_angle(fit(counted)->direction, expected->direction) > 0.1);
}

TEST_CASE("one failed element is split across its own tension") {
  const auto line = fit({torn({3, 4}, 1e-6, 0.7)});
  REQUIRE(line);
  CHECK(line->point == Vec2{3, 4});
  CHECK(off_angle(line->direction, at(0.7 + pi / 2)) == near(0, 1e-15));
}

TEST_CASE("a point under equal stresses counts for the centroid alone") {
  const WeightedPoint even{{2, 0}, 1, 1, {-20_MPa, -20_MPa, 0}};
  const auto line = fit({torn({0, 0}, 1, 0.3), even});
  REQUIRE(line);
  CHECK(off_angle(line->direction, at(0.3 + pi / 2)) == near(0, 1e-15));
  CHECK(line->point == Vec2{1, 0});
  CHECK_FALSE(fit({even}));
}

TEST_CASE("tensions that cancel determine no line") {
  CHECK_FALSE(fit({torn({0, 0}, 2, 0.4), torn({1, 1}, 2, 0.4 + pi / 2, 90_MPa)}));
  CHECK_FALSE(fit({torn({0, 0}, 1, 0), torn({1, 0}, 1, pi / 3), torn({0, 1}, 1, -pi / 3)}));
  CHECK(fit({torn({0, 0}, 2, 0.4), torn({1, 1}, 2.001, 0.4 + pi / 2)}));
  CHECK_FALSE(fit({}));
}

TEST_CASE("areas, positions and stresses that break a rule are refused") {
  const double infinite = std::numeric_limits<double>::infinity();
  const auto refuse = [](const WeightedPoint& p, const char* rule) {
    CHECK_MESSAGE(contains(message_of([&] { (void)fit({p}); }), rule), rule);
  };
  refuse(torn({0, 0}, -1, 0), "line fit: area of a point = -1");
  refuse(torn({0, 0}, 0, 0), "line fit: sum of the areas = 0");
  refuse(torn({0, infinite}, 1, 0), "line fit: position of a point");
  refuse({{0, 0}, 1, 1, {infinite, infinite, 0}}, "line fit: largest shear stress of a point");
}
