// SPDX-License-Identifier: BSL-1.0
#include <riprap/experiment/unconfined_result.hpp>

#include <doctest/doctest.h>
#include <utility>

#include <riprap/breakage/criterion/hoek_brown.hpp>
#include <riprap/breakage/line_fit/failure_plane_through_centroid.hpp>
#include <riprap/breakage/line_fit/weighted_xy.hpp>
#include <riprap/stress/mesher/uniform_mesher.hpp>
#include <support/near.hpp>
#include <support/rectangle.hpp>

using namespace riprap;
using test::near;

namespace {

// Compressed along axis 2 at twice the strength where the centroid lies close to a line through
// the centre, at half of it elsewhere.
UnconfinedResult banded(const Line& line) {
  UnconfinedResult r;
  r.mesh = UniformMesher{2000}(test::rectangle({0, 0}, 0.05, 0.1).ring());
  r.stress.reset(r.mesh.size());
  for (std::size_t e = 0; e < r.mesh.size(); ++e) {
    const bool fails = std::abs(line.left_distance(r.mesh.centroid(e))) < 0.003;
    r.stress.set(e, {0, fails ? 600e6 : 150e6, 0});
    r.elements.push_back(evaluate(HoekBrown{}, r.stress[e]));
  }
  r.failures = count_failures(HoekBrown{}, r.stress);
  return r;
}

template <class Result>
concept GivesSamplingPoints = requires(Result&& r) { std::forward<Result>(r).sampling_points(); };

// The points refer to the mesh of the result, which a temporary one takes along.
static_assert(GivesSamplingPoints<const UnconfinedResult&>);
static_assert(!GivesSamplingPoints<UnconfinedResult>);
static_assert(!GivesSamplingPoints<const UnconfinedResult>);

}  // namespace

TEST_CASE("the failure line runs along a band of failed elements") {
  const Line band{{0, 0}, Vec2{0.3, 1}.normalized()};
  const UnconfinedResult r = banded(band);
  const std::optional<Line> line = failure_line(r, HoekBrown{}, WeightedXY{});
  REQUIRE(line);
  // The band is 6 mm wide and 100 long, cut by a mesh of 2.5 mm.
  CHECK(std::abs(cross(line->direction, band.direction)) <= 0.02);
  CHECK(line->point.norm() <= 0.001);
  // A shear plane at pi/4 - phi/2 from axis 2, whatever the band: 12.3 degrees by eq. 7.
  const std::optional<Line> plane = failure_line(r, HoekBrown{}, FailurePlaneThroughCentroid{});
  REQUIRE(plane);
  CHECK(std::abs(plane->direction.x() / plane->direction.y()) ==
        near(std::tan(0.785398 - 0.5 * HoekBrown{}.friction_angle(0)), 1e-5));
}

TEST_CASE("no line where nothing failed") {
  UnconfinedResult r = banded({{9, 9}, Vec2{0, 1}});
  CHECK(r.ratio() == 0);
  CHECK(!failure_line(r, HoekBrown{}, WeightedXY{}));
  const auto always = [](std::span<const WeightedPoint>, const FailurePlanes&) {
    return std::optional<Line>(Line{{0, 0}, {0, 1}});
  };
  CHECK(!failure_line(r, HoekBrown{}, always));
}

TEST_CASE("platens press with positive forces, and slipping nodes are counted") {
  UnconfinedResult r;
  r.platen_nodes = {{.node = 0, .top = false, .force = {0, 5}, .slip = 1e-9},
                    {.node = 1, .top = false, .force = {2, -1}, .slip = 0},
                    {.node = 2, .top = true, .force = {0, -7}, .slip = -1e-9}};
  CHECK(r.platen_nodes[0].normal_force() == 5);
  CHECK(r.platen_nodes[2].normal_force() == 7);
  CHECK(r.least_normal_force() == -1);
  CHECK(r.slipping_nodes() == 2);
}
