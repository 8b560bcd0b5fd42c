// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <optional>
#include <span>

#include <riprap/breakage/line_fit/weighted_moments.hpp>
#include <riprap/core/units.hpp>
#include <riprap/simulation/simulation.hpp>
using namespace riprap;

struct AlongBedding {  // every crack has one direction and passes the middle of what has failed
  double angle = 0;    // from axis 1, laboratory axes [rad]
  std::optional<Line> operator()(std::span<const WeightedPoint> points,
                                 const FailurePlanes& /*planes*/) const {
    if (points.empty()) return std::nullopt;
    return Line{weighted_moments(points).mean, Vec2{std::cos(angle), std::sin(angle)}};
  }
};

int main() {
  const ConvexPolygon square{{0, 0}, {0.016, 0}, {0.016, 0.016}, {0, 0.016}};
  const ConvexPolygon platen{{-0.02, 0}, {0.04, 0}, {0.04, 0.016}, {-0.02, 0.016}};
  const Assembly pressed{.particles = {{square},  // 1 mm deep in a platen on either side
                                       {platen.moved({}, {0, 0.0150}), Motion::prescribed},
                                       {platen.moved({}, {0, -0.0150}), Motion::prescribed}}};
  Simulation sim{Model{}.line_fit(AlongBedding{.angle = 75_deg}), pressed, Rock{}};
  for (int i = 0; i < 3; ++i) sim.step();
  if (sim.breaks().empty()) return 1;
  return std::abs(sim.breaks()[0].line.direction.x() - std::cos(75_deg)) < 1e-12 ? 0 : 1;
}
