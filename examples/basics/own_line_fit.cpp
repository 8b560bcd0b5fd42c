// SPDX-License-Identifier: BSL-1.0
// own_line_fit: cracks along bedding planes; the areas of the pieces beside the closed form
// A line fit decides where a particle that fails is cut, from its failed elements.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <span>

#include <riprap/breakage/line_fit/weighted_moments.hpp>
#include <riprap/output/assembly_picture.hpp>
#include <riprap/riprap.hpp>
using namespace riprap;

/// The crack follows the bedding plane nearest to the middle of the failed elements. Planes are
/// fixed in the laboratory axes, for particles that do not turn.
struct BeddingPlanes {
  double angle = 90_deg;   // from axis 1 [rad]
  double spacing = 0.005;  // [m]; one plane passes the origin
  std::optional<Line> operator()(std::span<const WeightedPoint> points,
                                 const FailurePlanes& /*planes*/) const {
    if (points.empty()) return std::nullopt;
    const Vec2 direction{std::cos(angle), std::sin(angle)};
    const Vec2 normal{-direction.y(), direction.x()};
    const double offset = normal.dot(weighted_moments(points).mean);
    return Line{spacing * std::round(offset / spacing) * normal, direction};
  }
};

int main() {
  const double side = 0.016;  // [m]
  const ConvexPolygon square{{0, 0}, {side, 0}, {side, side}, {0, side}};
  const ConvexPolygon platen{{-0.02, 0}, {0.04, 0}, {0.04, 0.016}, {-0.02, 0.016}};
  const Assembly pressed{.particles = {{square},  // 1 mm deep in a platen on either side
                                       {platen.moved({}, {0, 0.0150}), Motion::prescribed},
                                       {platen.moved({}, {0, -0.0150}), Motion::prescribed}}};
  Simulation sim{Model{}.line_fit(BeddingPlanes{}), pressed, Rock{}};
  sim.step();
  if (sim.breaks().empty()) return 1;

  // Planes stand at 0, 5, 10 and 15 mm; the load is symmetric about 8 mm, so the nearest is at 10
  // mm.
  const auto [smaller, larger] = std::minmax(sim.breaks()[0].areas[0], sim.breaks()[0].areas[1]);
  std::printf("areas of the pieces %.3f and %.3f mm^2, closed form %.3f and %.3f mm^2\n",
              1e6 * smaller, 1e6 * larger, 6.0 * 16, 10.0 * 16);
  assembly_picture(sim.particles(), {}, "A crack along a bedding plane").save("own_line_fit.svg");
  std::printf("picture in own_line_fit.svg\n");
  const double round_off = 1e-12;
  return std::abs(smaller / (0.006 * side) - 1) <= round_off &&
                 std::abs(larger / (0.010 * side) - 1) <= round_off
             ? 0
             : 1;
}
