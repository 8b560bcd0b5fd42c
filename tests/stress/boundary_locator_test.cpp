// SPDX-License-Identifier: BSL-1.0
#include <riprap/stress/boundary_locator.hpp>

#include <doctest/doctest.h>

#include <support/loaded_particle.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near;

TEST_CASE("an outline finds the boundary points that the mesh finds") {
  Random random(51);
  for (int sample = 0; sample < 30; ++sample) {
    const Mesh mesh = test::random_mesh(random, 60);
    const BoundaryLocator locator(mesh);
    CHECK(locator.nodes() == mesh.boundary_nodes);
    for (int k = 0; k < 50; ++k) {
      const Vec2 x{random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02)};
      const BoundaryPoint found = locator.nearest(x).at;
      const BoundaryPoint expected = mesh.nearest_boundary_point(x);
      CHECK(found.node == expected.node);
      CHECK(found.next == expected.next);
      CHECK(found.weight == expected.weight);
    }
  }
}

TEST_CASE("as long as a place moves by less than its hold, its edge stays the same") {
  const auto edge_of = [](const Mesh& mesh, std::uint32_t node) {
    return std::upper_bound(mesh.corners.begin(), mesh.corners.end(), node) - mesh.corners.begin();
  };
  Random random(52);
  int other_edge = 0;
  for (int sample = 0; sample < 30; ++sample) {
    const Mesh mesh = test::random_mesh(random, 60);
    const BoundaryLocator locator(mesh);
    for (int k = 0; k < 200; ++k) {
      const Vec2 x{random.uniform(-0.01, 0.01), random.uniform(-0.01, 0.01)};
      const LocatedPoint here = locator.nearest(x);
      const Rotation way = Rotation::from_angle(random.uniform(-3.2, 3.2));
      const Vec2 step = here.valid_radius * Vec2{way.cosine, way.sine};
      if (here.valid_radius < 1e-12) continue;  // at a corner, where it is nothing but round-off
      const auto edge = edge_of(mesh, here.at.node);
      CHECK(edge_of(mesh, locator.nearest(x + 0.999 * step).at.node) == edge);
      other_edge += edge_of(mesh, locator.nearest(x + 1.5 * step).at.node) != edge;
    }
  }
  CHECK(other_edge > 100);  // the hold is not much smaller than it might be
}
