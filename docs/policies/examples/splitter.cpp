// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <optional>

#include <riprap/simulation/simulation.hpp>
using namespace riprap;

struct FairCut {       // refuses a cut that leaves one piece too small a share of its parent
  double least = 0.2;  // share of the parent's area [-]
  std::optional<CutRings> operator()(Ring ring, const Line& line, double /*mean_area*/) const {
    std::optional<CutRings> parts = cut(ring, line, 1e-3);
    if (!parts) return std::nullopt;
    const double smaller =
        std::min(area_properties(parts->left).area, area_properties(parts->right).area);
    if (smaller < least * area_properties(ring).area) return std::nullopt;
    return parts;
  }
  void validate() const { require(least < 0.5, "FairCut.least", least, "must be below 0.5"); }
};

int main() {
  const ConvexPolygon square{{0, 0}, {0.016, 0}, {0.016, 0.016}, {0, 0.016}};
  const ConvexPolygon platen{{-0.02, 0}, {0.04, 0}, {0.04, 0.016}, {-0.02, 0.016}};
  const Assembly pressed{.particles = {{square},  // 1 mm deep in a platen on either side
                                       {platen.moved({}, {0, 0.0150}), Motion::prescribed},
                                       {platen.moved({}, {0, -0.0150}), Motion::prescribed}}};
  Simulation sim{Model{}.splitter(FairCut{.least = 0.3}), pressed, Rock{}};
  for (int i = 0; i < 3; ++i) sim.step();
  if (sim.breaks().empty()) return 1;
  const auto& areas = sim.breaks()[0].areas;
  return std::min(areas[0], areas[1]) >= 0.3 * 0.016 * 0.016 ? 0 : 1;
}
