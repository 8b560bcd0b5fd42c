// SPDX-License-Identifier: BSL-1.0
#include <riprap/stress/sampling_points.hpp>

#include <doctest/doctest.h>
#include <type_traits>

#include <support/loaded_particle.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near_relative;

namespace {

// Two points on the median of the first corner, of unequal shares.
constexpr std::array<TrianglePoint, 2> rule{TrianglePoint{{0.5, 0.25, 0.25}, 0.25},
                                            TrianglePoint{{0.2, 0.4, 0.4}, 0.75}};

// A mesh does not say which element its stresses are of, and a temporary one does not last.
static_assert(!std::is_convertible_v<const Mesh&, SamplingPoints>);
static_assert(!std::is_constructible_v<SamplingPoints, Mesh>);

}  // namespace

TEST_CASE("a mesh is sampled in its centroids unless a rule is given") {
  Random random(61);
  const Mesh mesh = test::random_mesh(random, 60);
  const SamplingPoints points(mesh);
  REQUIRE(points.size() == mesh.size());
  for (std::size_t e = 0; e < mesh.size(); ++e) {
    CHECK(points.position(e) == mesh.centroid(e));  // the same bytes
    CHECK(points.area(e) == mesh.area(e));
  }
}

TEST_CASE("the points of a triangle follow each other and share its area") {
  Mesh mesh;
  mesh.nodes = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  const SamplingPoints points(mesh, rule);
  REQUIRE(points.size() == 4);
  CHECK(points.triangle(1) == 0);
  CHECK(points.triangle(2) == 1);
  CHECK((points.position(0) - Vec2{2, 1}).norm() <= 1e-15);
  CHECK((points[3].position - Vec2{1.6, 3.2}).norm() <= 1e-15);
  CHECK(points[0].area == near_relative(2, 1e-15));
  CHECK(points[3].area == near_relative(6, 1e-15));
}

TEST_CASE("a rule stands for the whole triangle") {
  CHECK(is_triangle_rule(centroid_rule));
  CHECK(is_triangle_rule(rule));
  CHECK_FALSE(is_triangle_rule(std::array<TrianglePoint, 0>{}));
  CHECK_FALSE(is_triangle_rule(std::array<TrianglePoint, 2>{}));  // shares of 2
  CHECK_FALSE(is_triangle_rule(std::array{TrianglePoint{{0.5, 0.5, 0.5}, 1}}));
  CHECK_FALSE(
      is_triangle_rule(std::array{TrianglePoint{{1, 0, 0}, 1.5}, TrianglePoint{{0, 1, 0}, -0.5}}));
}
