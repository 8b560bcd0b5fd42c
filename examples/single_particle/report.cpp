// SPDX-License-Identifier: BSL-1.0
// Forces, failure, line and pieces in plain text.

#include "report.hpp"

#include <cmath>
#include <cstdio>
#include <numbers>

using namespace riprap;

namespace {

// Rounded, without the sign of a zero.
double whole(double value) { return std::round(value) + 0.0; }

void print_forces(const Analysis& a) {
  std::printf("%zu vertices, area %.1f mm^2, thickness %.1f mm; mesh of %zu triangles\n",
              a.given.polygon.size(), 1e6 * area_properties(a.given.polygon.ring()).area,
              1e3 * a.given.thickness, a.mesh.size());
  for (std::size_t i = 0; i < a.loads.size(); ++i) {
    const Vec2 at = 1e3 * a.at(a.loads[i]);
    std::printf("force %zu at (%.2f, %.2f) mm: (%.0f, %.0f) N", i, at.x(), at.y(),
                a.loads[i].force_body.x(), a.loads[i].force_body.y());
    if (a.is_pin(i))
      std::printf("; pinned, reaction (%.0f, %.0f) N", whole(a.balanced[i].force_body.x()),
                  whole(a.balanced[i].force_body.y()));
    std::printf("\n");
  }
  const Wrench rest = a.unbalanced();
  std::printf("left over by the forces as given: (%.1f, %.1f) N, %.3f N m; taken by the %s\n",
              rest.force.x(), rest.force.y(), rest.moment,
              a.given.pinned ? "two pinned contacts" : "particle's inertia");
}

void print_line(const char* name, const std::optional<Line>& line, const FailurePlanes& planes) {
  if (!line) {
    std::printf("%s line: none\n", name);
    return;
  }
  const double degrees = 180 / std::numbers::pi;
  double angle = std::atan2(line->direction.y(), line->direction.x());
  if (angle < 0) angle += std::numbers::pi;
  std::printf(
      "%s line: at %.1f degrees through (%.2f, %.2f) mm, %.1f degrees off a failure plane\n", name,
      degrees * angle, 1e3 * line->point.x(), 1e3 * line->point.y(),
      degrees * planes.angle_to(line->direction));
}

}  // namespace

void print_report(const Analysis& a) {
  print_forces(a);
  std::printf("Rat %.3f (%zu of %zu elements have failed), RatF %g\n", a.failures.ratio(),
              a.failures.failed, a.failures.elements, a.given.trigger.critical);
  if (std::isfinite(a.failures.lowest_safety_factor))
    std::printf("lowest safety factor %.3f, mode: %s\n", a.failures.lowest_safety_factor,
                to_text(a.first_failed().mode));
  else
    std::printf("no element bears compression or has failed: no safety factor\n");
  if (a.failures.failed > 0) {
    print_line("X", a.by_x, a.planes);
    print_line("Y", a.by_y, a.planes);
    if (a.line()) std::printf("chosen: the %s line\n", a.x_chosen ? "X" : "Y");
  }
  if (a.pieces)
    for (const auto& [name, piece] : {std::pair{"A", &a.pieces->left}, {"B", &a.pieces->right}})
      std::printf("piece %s: %.1f mm^2, aspect %.2f\n", name, 1e6 * area_properties(*piece).area,
                  aspect(*piece));
  std::printf("%s\n", a.crack ? "The particle breaks." : a.refusal.c_str());
}
