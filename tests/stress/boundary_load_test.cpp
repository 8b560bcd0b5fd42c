#include <riprap/stress/boundary_load.hpp>

#include <doctest/doctest.h>

#include <riprap/stress/mesh/uniform_mesher.hpp>
#include <support/polygons.hpp>

using namespace riprap;

TEST_CASE("a load between two nodes, shared by its weights, keeps its force and its moment") {
  const Mesh mesh = UniformMesher{40}(test::regular_polygon(5, 0.01, 0.3).ring());
  for (std::uint32_t node = 0; node < mesh.boundary_nodes; ++node)
    for (const double weight : {0.0, 0.2, 0.77, 1.0}) {
      const BoundaryLoad load{{node, (node + 1) % mesh.boundary_nodes, weight}, {300, -170}, 0};
      const Vec2 first = load.at.weight * load.force;
      const Vec2 second = (1 - load.at.weight) * load.force;
      const double moment =
          cross(mesh.nodes[load.at.node], first) + cross(mesh.nodes[load.at.next], second);
      // Round-off of products of 0.01 m and 300 N.
      CHECK((first + second - load.force).norm() <= 1e-12);
      CHECK(std::abs(moment - cross(mesh.position(load.at), load.force)) <= 1e-14);
    }
}

TEST_CASE("a boundary load is none until it is given a force") {
  CHECK(BoundaryLoad{}.force == Vec2{0, 0});
  CHECK(BoundaryLoad{}.normal_force == 0);
}
