// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <cstdint>

#include <riprap/simulation/simulation.hpp>
#include <riprap/stress/mesher/fan_mesher.hpp>
using namespace riprap;

struct Refined {  // a coarse fan, each triangle cut in three at its own centroid
  unsigned edge_divisions = 4;
  Mesh operator()(Ring ring) const {
    const Mesh coarse = FanMesher{edge_divisions}(ring);
    Mesh mesh = coarse;
    mesh.triangles.clear();
    for (std::size_t e = 0; e < coarse.size(); ++e) {
      const auto [p, q, r] = coarse.triangles[e];
      const auto middle = static_cast<std::uint32_t>(mesh.nodes.size());
      mesh.nodes.push_back(coarse.centroid(e));
      for (const auto& edge : {std::array{p, q}, std::array{q, r}, std::array{r, p}})
        mesh.triangles.push_back({edge[0], edge[1], middle});
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
  Simulation sim{Model{}.mesher(Refined{}), pressed, Rock{}};
  for (int i = 0; i < 3; ++i) sim.step();
  return sim.mesh(0).size() == 3 * 4 * sim.particles().ring(0).size() ? 0 : 1;
}
