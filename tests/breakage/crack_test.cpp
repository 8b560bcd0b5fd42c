// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/crack.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include <riprap/breakage/criterion/hoek_brown.hpp>
#include <riprap/breakage/line_fit/failure_plane_through_centroid.hpp>
#include <riprap/breakage/line_fit/mean_tension_line.hpp>
#include <riprap/breakage/line_fit/no_line.hpp>
#include <riprap/breakage/line_fit/total_least_squares.hpp>
#include <riprap/breakage/splitter/straight_cut.hpp>
#include <riprap/core/units.hpp>
#include <riprap/stress/element/linear_strain_triangle.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>
#include <support/point_clouds.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

// A square of side 2 about the origin: 4 by 4 cells of two triangles each.
Mesh square_mesh() {
  Mesh mesh;
  for (int j = 0; j <= 4; ++j)
    for (int i = 0; i <= 4; ++i) mesh.nodes.push_back({0.5 * i - 1, 0.5 * j - 1});
  for (std::uint32_t j = 0; j < 4; ++j)
    for (std::uint32_t i = 0; i < 4; ++i) {
      const std::uint32_t p = 5 * j + i;
      mesh.triangles.push_back({p, p + 1, p + 6});
      mesh.triangles.push_back({p, p + 6, p + 5});
    }
  return mesh;
}

// Tension along axis 1 in the two middle columns of cells, twice the strength; a little more in one
// element. In the other cells there is no stress.
constexpr std::size_t worst = 11;
ElementStress torn_in_the_middle(const Mesh& mesh) {
  ElementStress stress;
  stress.reset(mesh.size());
  for (std::size_t e = 0; e < mesh.size(); ++e)
    if (std::abs(mesh.centroid(e).x()) < 0.5)
      stress.set(e, {e == worst ? -24.001_MPa : -24_MPa, 0, 0});
  return stress;
}

Body body_at(double angle, const Vec2& position) {
  Body body;
  body.rotation = Rotation::from_angle(angle);
  body.position = position;
  return body;
}

std::vector<Vec2> square_ring(const Body& body) {
  std::vector<Vec2> ring;
  for (const Vec2& v : {Vec2{-1, -1}, Vec2{1, -1}, Vec2{1, 1}, Vec2{-1, 1}})
    ring.push_back(body.rotation * v + body.position);
  return ring;
}

// Through the first failed element, along the major direction of the mean stress.
struct AlongMeanStress {
  Line operator()(std::span<const WeightedPoint> points, const FailurePlanes&,
                  const Stress2& mean) const {
    // Half of the particle is under 24 MPa; the worst element has a little more.
    CHECK(mean.principal_values().minor == near_relative(-12_MPa, 1e-5));
    return {points[0].position, mean.principal().major_direction};
  }
};

template <class Fit, class SplitterType = StraightCut>
struct Breakage {
  HoekBrown criterion{};
  Fit line_fit{};
  SplitterType splitter{};
};

// Calls pieces beyond a coordinate dust.
struct DustToTheRight : StraightCut {
  double from = 0;
  [[nodiscard]] bool is_dust(Ring piece, double) const {
    return area_properties(piece).centroid.x() > from;
  }
};

template <class Fit, class SplitterType>
std::optional<Crack> crack_of(const Breakage<Fit, SplitterType>& model, const Body& body,
                              double mean_area) {
  const Mesh mesh = square_mesh();
  const ElementStress stress = torn_in_the_middle(mesh);
  const std::vector<Vec2> ring = square_ring(body);
  return find_crack(model, count_failures(model.criterion, stress), SamplingPoints(mesh), stress,
                    body, ring, mean_area);
}

}  // namespace

TEST_CASE("points of the line fit are the centroids of failed elements with their weights") {
  const Mesh mesh = square_mesh();
  const Body body = body_at(0.7, {5, -3});
  const auto points =
      failed_points(HoekBrown{}, SamplingPoints(mesh), torn_in_the_middle(mesh), body);
  REQUIRE(points.size() == 16);
  std::size_t k = 0;
  for (std::size_t e = 0; e < mesh.size(); ++e) {
    if (std::abs(mesh.centroid(e).x()) >= 0.5) continue;
    CHECK((points[k].position - (body.rotation * mesh.centroid(e) + body.position)).norm() ==
          near(0, 1e-14));
    // Twice the tensile strength of 12 MPa.
    CHECK(points[k].weight == near(2, e == worst ? 1e-3 : 1e-14));
    CHECK(points[k].area == 0.125);
    const PrincipalStress principal = points[k].stress.principal();
    CHECK(principal.minor == near_relative(e == worst ? -24.001_MPa : -24_MPa, 1e-14));
    CHECK(off_angle(principal.major_direction, body.rotation * Vec2{0, 1}) == near(0, 1e-14));
    ++k;
  }
}

TEST_CASE("a piece may be dust, but not both") {
  using Model = Breakage<FailurePlaneThroughCentroid, DustToTheRight>;
  const Body body = body_at(0, {5, 0});  // pieces at 4.5 and 5.5
  const auto one = crack_of(Model{.splitter = {{}, 5}}, body, 4);
  REQUIRE(one);
  const bool left_is_at_the_left = area_properties(one->pieces.left).centroid.x() < 5;
  CHECK(one->is_dust[0] == !left_is_at_the_left);
  CHECK(one->is_dust[1] == left_is_at_the_left);
  const auto none = crack_of(Model{.splitter = {{}, 6}}, body, 4);
  REQUIRE(none);
  CHECK_FALSE((none->is_dust[0] || none->is_dust[1]));
  CHECK_FALSE(crack_of(Model{.splitter = {{}, 4}}, body, 4));
}

TEST_CASE("a particle torn in its middle splits there, whatever its pose") {
  for (const double angle : {0.0, 0.7, -2.1})
    for (const Vec2& position : {Vec2{0, 0}, Vec2{40, -25}}) {
      CAPTURE(angle);
      const Body body = body_at(angle, position);
      const Vec2 across_tension = body.rotation * Vec2{0, 1};
      // The crack along the cloud of failed elements, and the one along the failure plane of the
      // first of them. The cells lean one way: a few degrees for the cloud.
      const auto cloud = crack_of(Breakage<TotalLeastSquares>{}, body, 4);
      const auto plane = crack_of(Breakage<FailurePlaneThroughCentroid>{}, body, 4);
      const auto tension = crack_of(Breakage<MeanTensionLine>{}, body, 4);
      const auto mean = crack_of(Breakage<AlongMeanStress>{}, body, 4);
      REQUIRE(cloud);
      REQUIRE(plane);
      REQUIRE(tension);
      REQUIRE(mean);
      CHECK(off_angle(tension->line.direction, across_tension) == near(0, 1e-13));
      CHECK(off_angle(mean->line.direction, across_tension) == near(0, 1e-13));
      CHECK(off_angle(cloud->line.direction, across_tension) < 0.06);
      CHECK(off_angle(plane->line.direction, across_tension) == near(0, 1e-13));
      for (const Crack& crack : {*cloud, *plane, *tension}) {
        CHECK(crack.mode == FailureMode::tension);
        CHECK(crack.failures.failed == 16);
        CHECK(crack.failures.ratio() == 0.5);
        CHECK(crack.failures.first_failed == worst);
        // The worst element's weight moves the centroid by some 1e-6.
        CHECK(crack.line.left_distance(position) == near(0, 1e-5));
        const double left = area_properties(crack.pieces.left).area;
        const double right = area_properties(crack.pieces.right).area;
        CHECK(left == near(2, 1e-4));
        // Coordinates are rounded to 40 * 1.1e-16.
        CHECK(left + right == near(4, 1e-13));
        CHECK(crack.line.left_distance(area_properties(crack.pieces.left).centroid) > 0.4);
        CHECK(crack.line.left_distance(area_properties(crack.pieces.right).centroid) < -0.4);
      }
    }
}

TEST_CASE("there is no crack where there is no line or the splitter refuses") {
  const Body body = body_at(0.3, {1, 2});
  CHECK_FALSE(crack_of(Breakage<NoLine>{}, body, 4));
  // Halves of a particle that is small beside the others.
  CHECK_FALSE(crack_of(Breakage<TotalLeastSquares>{}, body, 2 / 0.08 + 0.1));
  CHECK(crack_of(Breakage<TotalLeastSquares>{}, body, 2 / 0.08 - 0.1));
}

TEST_CASE("a particle without failed elements has no crack") {
  const Mesh mesh = square_mesh();
  ElementStress stress;
  stress.reset(mesh.size());
  const Body body = body_at(0, {0, 0});
  const Breakage<FailurePlaneThroughCentroid> model;
  CHECK_FALSE(find_crack(model, count_failures(model.criterion, stress), SamplingPoints(mesh),
                         stress, body, square_ring(body), 4));
}

TEST_CASE("stresses of other sampling points than those given are refused") {
  const Mesh mesh = square_mesh();
  const Body body = body_at(0, {0, 0});
  ElementStress stress;
  stress.reset(LinearStrainTriangle::sampling_points.size() * mesh.size());
  for (std::size_t i = 0; i < stress.size(); ++i) stress.set(i, {-100e6, 0, 0});  // all fail
  const Breakage<TotalLeastSquares> model;
  const FailureCount failures = count_failures(model.criterion, stress);
  const std::string rule = "SamplingPoints.size() = " + to_text(static_cast<double>(mesh.size())) +
                           ": must be that of the ElementStress";
  CHECK(test::message_of([&] {
          (void)failed_points(model.criterion, SamplingPoints(mesh), stress, body);
        }) == rule);
  CHECK(test::message_of([&] {
          (void)find_crack(model, failures, SamplingPoints(mesh), stress, body, square_ring(body),
                           4);
        }) == rule);
  const SamplingPoints samples(mesh, LinearStrainTriangle::sampling_points);
  CHECK(failed_points(model.criterion, samples, stress, body).size() == stress.size());
}
