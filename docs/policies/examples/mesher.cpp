#include <cstdint>

#include <riprap/simulation/simulation.hpp>
using namespace riprap;

struct Fan {  // one triangle from each edge to the centroid: coarse and quick
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
};

int main() {
  const ConvexPolygon square{{0, 0}, {0.016, 0}, {0.016, 0.016}, {0, 0.016}};
  const ConvexPolygon platen{{-0.02, 0}, {0.04, 0}, {0.04, 0.016}, {-0.02, 0.016}};
  const Assembly pressed{.particles = {{square},  // 1 mm deep in a platen on either side
                                       {platen.moved({}, {0, 0.0150}), Motion::prescribed},
                                       {platen.moved({}, {0, -0.0150}), Motion::prescribed}}};
  Simulation sim{Model{}.mesher(Fan{}), pressed, Rock{}};
  for (int i = 0; i < 3; ++i) sim.step();
  return sim.mesh(0).size() == sim.particles().ring(0).size() ? 0 : 1;
}
