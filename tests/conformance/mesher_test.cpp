// SPDX-License-Identifier: BSL-1.0
#include <cstdint>
#include <doctest/doctest.h>
#include <support/violated.hpp>
#include <utility>

#include <riprap/conformance/mesher.hpp>
#include <riprap/stress/mesher/fan_mesher.hpp>
#include <riprap/stress/mesher/uniform_mesher.hpp>

using namespace riprap;
using test::check_violated;

namespace {

struct Fan {
  Mesh operator()(Ring ring) const {
    const auto n = static_cast<std::uint32_t>(ring.size());
    Mesh mesh;
    mesh.nodes.assign(ring.begin(), ring.end());
    mesh.nodes.push_back(Vec2{0, 0});
    mesh.boundary_nodes = n;
    for (std::uint32_t i = 0; i < n; ++i) {
      mesh.corners.push_back(i);
      mesh.triangles.push_back({i, (i + 1) % n, n});
    }
    return mesh;
  }
  void validate() const {}
};

/// The fan with something done to it.
template <class Change>
struct Altered : Fan {
  Change change;
  Mesh operator()(Ring ring) const {
    Mesh mesh = Fan::operator()(ring);
    change(mesh);
    return mesh;
  }
};

template <class Change>
Violations violations_of(Change change) {
  return mesher_violations(Altered<Change>{{}, change});
}

/// Divides the first edge in two, at `share` of its length.
struct DividedEdge {
  double share = 0.5;
  Mesh operator()(Ring ring) const {
    std::vector<Vec2> vertices(ring.begin(), ring.end());
    vertices.insert(vertices.begin() + 1, vertices[0] + share * (vertices[1] - vertices[0]));
    Mesh mesh = Fan{}(vertices);
    mesh.corners.erase(mesh.corners.begin() + 1);
    return mesh;
  }
  void validate() const {}
};

/// As many triangles as have room for a millimetre.
struct ByTheMillimetre {
  double edge = 1e-3;
  Mesh operator()(Ring ring) const {
    if (diameter(ring) > 20 * edge) return UniformMesher{.triangles = 50}(ring);
    return Fan{}(ring);
  }
  void validate() const {}
};

}  // namespace

TEST_CASE("the meshers of riprap obey the axioms") {
  CHECK(to_text(mesher_violations(UniformMesher{})) == "");
  CHECK(to_text(mesher_violations(UniformMesher{.triangles = 20}, 10)) == "");
  CHECK(to_text(mesher_unit_violations(UniformMesher{}, UniformMesher{})) == "");
  CHECK(to_text(mesher_violations(FanMesher{})) == "");
  CHECK(to_text(mesher_violations(FanMesher{.edge_divisions = 1}, 10)) == "");
  CHECK(to_text(mesher_unit_violations(FanMesher{}, FanMesher{})) == "");
}

TEST_CASE("users' meshers obey the axioms") {
  CHECK(to_text(mesher_violations(Fan{})) == "");
  CHECK(to_text(mesher_violations(DividedEdge{})) == "");
  CHECK(to_text(mesher_unit_violations(Fan{}, Fan{})) == "");
  CHECK(to_text(mesher_unit_violations(ByTheMillimetre{}, ByTheMillimetre{.edge = 1})) == "");
}

TEST_CASE("a mesher that does not cover the polygon is reported") {
  const Violations gap = violations_of([](Mesh& mesh) { mesh.triangles.pop_back(); });
  check_violated(gap, "the triangles have the area of the polygon");
  check_violated(gap, "the triangles have the centroid of the polygon");
  check_violated(gap, "the triangles have the polar moment of the polygon");
  check_violated(gap, "triangles join edge to edge");
}

TEST_CASE("a mesher with triangles the wrong way round is reported") {
  check_violated(
      violations_of([](Mesh& mesh) { std::swap(mesh.triangles[0][0], mesh.triangles[0][1]); }),
      "triangles are counter-clockwise: area");
}

TEST_CASE("a mesher that loses the boundary is reported") {
  check_violated(violations_of([](Mesh& mesh) { mesh.corners.pop_back(); }),
                 "every vertex of the polygon is a corner, vertex 0 node 0");
  check_violated(violations_of([](Mesh& mesh) { std::swap(mesh.corners[1], mesh.corners[2]); }),
                 "corners come in the order of the vertices");
  check_violated(mesher_violations(DividedEdge{.share = 0.4}),
                 "boundary nodes divide each edge evenly: distance from their place");
}

TEST_CASE("a mesher with a length of its own is reported in other units") {
  check_violated(mesher_unit_violations(ByTheMillimetre{}, ByTheMillimetre{}),
                 "triangles are the same in other units");
  check_violated(mesher_unit_violations(DividedEdge{.share = 0.5}, DividedEdge{.share = 0.4}),
                 "nodes are the same in other units: distance");
}
