// SPDX-License-Identifier: BSL-1.0
#include <riprap/stress/boundary_locator.hpp>

#include <doctest/doctest.h>

#include <support/loaded_particle.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near;

TEST_CASE("no sampled point of the boundary is nearer than the one that is located") {
  Random random(51);
  for (int sample = 0; sample < 30; ++sample) {
    const Mesh mesh = test::random_mesh(random, 60);
    const BoundaryLocator locator(mesh);
    CHECK(locator.nodes() == mesh.boundary_nodes);
    for (int k = 0; k < 20; ++k) {
      const Vec2 x{random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02)};
      const double distance = (mesh.position(locator.nearest(x).at) - x).norm();
      for (std::uint32_t node = 0; node < mesh.boundary_nodes; ++node)
        for (const double weight : {0.0, 0.3, 0.6}) {
          const Vec2 other = mesh.position({node, (node + 1) % mesh.boundary_nodes, weight});
          CHECK((other - x).norm() >= distance - 1e-16);
        }
    }
  }
}

TEST_CASE("while a position moves by less than the valid radius, its edge stays the nearest") {
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
  CHECK(other_edge > 100);  // the radius is not much smaller than it might be
}
