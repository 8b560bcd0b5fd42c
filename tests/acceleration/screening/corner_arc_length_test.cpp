// SPDX-License-Identifier: BSL-1.0
#include <riprap/acceleration/screening/corner_arc_length.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <support/loaded_particle.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near;

namespace {

// Of places in single precision: four times half a unit in the last place of 16 mm.
constexpr double round_off = 4e-9;

// A place within a hundredth or so of the size from a corner, and where it is on the boundary.
struct Near {
  Near(const Mesh& mesh, const BoundaryLocator& locator, Random& random) {
    const std::uint32_t node =
        mesh.corners[random.uniform_integer(0, static_cast<unsigned>(mesh.corners.size()) - 1)];
    const double deep = std::pow(10, random.uniform(-4, -2));
    const Rotation aside = Rotation::from_angle(random.uniform(-0.01, 0.01));
    place = aside * ((1 - deep) * mesh.nodes[node]);
    point = locator.nearest(place);
  }
  Vec2 place;
  LocatedPoint point;
};

CornerArcLength::Projections projections_at(const CornerArcLength& corner, const Vec2& place) {
  return corner.projections(static_cast<float>(place.x()), static_cast<float>(place.y()));
}

}  // namespace

TEST_CASE("the arc length is that between the boundary points, also across a corner") {
  Random random(61);
  int round = 0;
  int checked = 0;
  for (int sample = 0; sample < 100; ++sample) {
    const Mesh mesh = test::random_mesh(random, 100);
    const BoundaryLocator locator(mesh);
    for (int k = 0; k < 20; ++k) {
      const Near then(mesh, locator, random);
      if (!(then.point.corner_radius > 1e-5)) continue;
      const CornerArcLength corner(then.point, then.point.corner_radius, round_off);
      const Rotation way = Rotation::from_angle(random.uniform(-3.2, 3.2));
      const double far = std::pow(10, random.uniform(-3, 0)) * then.point.corner_radius;
      const Vec2 place = then.place + 0.999 * far * Vec2{way.cosine, way.sine};
      const LocatedPoint now = locator.nearest(place);
      const CornerArcLength::Projections projections = projections_at(corner, place);
      // Both are known from the same corner.
      REQUIRE(now.corner == then.point.corner);
      const double expected = std::abs(now.from_corner - then.point.from_corner);
      const auto found = static_cast<double>(corner.arc_length(projections));
      if (std::abs(projections.before - projections.after) > corner.round_off)
        CHECK(found == near(expected, round_off));
      else
        CHECK(found >= expected - round_off);
      CHECK(static_cast<double>(projections.longer_arc()) >= expected - round_off);
      round += now.from_corner * then.point.from_corner < 0;
      ++checked;
    }
  }
  CHECK(checked > 1000);
  CHECK(round > 100);
}

TEST_CASE("no way is longer by more than the place has moved while it stays on its edge") {
  Random random(62);
  int other_edge = 0;
  int checked = 0;
  for (int sample = 0; sample < 100; ++sample) {
    const Mesh mesh = test::random_mesh(random, 100);
    const BoundaryLocator locator(mesh);
    for (int k = 0; k < 20; ++k) {
      const Near then(mesh, locator, random);
      if (!(then.point.corner_radius > 1e-5)) continue;
      const CornerArcLength corner(then.point, then.point.corner_radius, round_off);
      const auto valid_radius =
          static_cast<double>(corner.edge_radius(projections_at(corner, then.place)));
      if (!(valid_radius > 1e-7 && valid_radius < then.point.corner_radius)) continue;
      const Rotation way = Rotation::from_angle(random.uniform(-3.2, 3.2));
      const Vec2 step = valid_radius * Vec2{way.cosine, way.sine};
      const double before = then.point.from_corner;
      const double after = locator.nearest(then.place + 0.999 * step).from_corner;
      CHECK(before * after > 0);
      CHECK(std::abs(after - before) <= valid_radius);
      // It is not much smaller than it might be.
      other_edge += locator.nearest(then.place + 2 * step).from_corner * before < 0;
      ++checked;
    }
  }
  CHECK(checked > 500);
  CHECK(other_edge > 50);
}

TEST_CASE("without a corner the valid radius is negative") {
  CHECK(CornerArcLength{}.valid_radius < 0);
  CHECK(CornerArcLength(LocatedPoint{}, -1e-9, round_off).valid_radius < 0);
}
