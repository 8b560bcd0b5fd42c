// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A picture of the ways that particles have gone during shear.

#include <algorithm>
#include <string>
#include <vector>

#include <riprap/experiment/displacement_paths.hpp>
#include <riprap/output/assembly_view.hpp>

namespace riprap {

namespace internal {

/// All points of all paths.
[[nodiscard]] inline std::vector<Vec2> points_of(const DisplacementPaths& record) {
  std::vector<Vec2> out;
  for (const auto& path : record.paths())
    out.insert(out.end(), path.points.begin(), path.points.end());
  return out;
}

/// The longest straight way from the first to the last point of a path of an intact particle [m].
[[nodiscard]] inline double largest_displacement(const DisplacementPaths& record) {
  double largest = 0;
  for (const auto& path : record.paths())
    if (path.particle.generation == 0 && !path.points.empty())
      largest = std::max(largest, (path.points.back() - path.points.front()).norm());
  return largest;
}

inline constexpr auto branch_style =
    "stroke=\"#c0392b\" stroke-width=\"0.8\" stroke-dasharray=\"1.5 2\"";
inline constexpr double path_dot = 1.7;  // pixels

[[nodiscard]] inline std::string path_colour(const Ancestry& particle) {
  return particle.generation > 0 ? "#c0392b" : "#1f4e79";
}
[[nodiscard]] inline std::string path_style(const Ancestry& particle) {
  return "fill=\"none\" stroke=\"" + path_colour(particle) + "\" stroke-width=\"1.1\"";
}
[[nodiscard]] inline std::string dot_style(const Ancestry& particle) {
  return "fill=\"" + path_colour(particle) + "\"";
}

inline void displacement_legend(Svg& svg, const Vec2& corner, double largest) {
  Vec2 at = corner;
  const Vec2 row{0, 24};
  const Vec2 rise{0, -5};
  const Vec2 end{24, -5};
  const Vec2 label{36, 0};
  for (const unsigned generation : {0u, 1u}) {
    const Ancestry particle{.generation = generation};
    svg.line(at + rise, at + end, path_style(particle));
    svg.circle(at + end, path_dot, dot_style(particle));
    svg.text(at + label, generation > 0 ? "piece" : "intact particle");
    at += row;
  }
  svg.line(at + rise, at + end, branch_style);
  svg.text(at + label, "parent to piece");
  svg.text(at + row, "dots: centroids now");
  const UnitPrefix prefix = unit_prefix(largest);
  svg.text(at + 2.5 * row, "largest displacement");
  svg.text(at + 3.25 * row, "of an intact particle:");
  svg.text(at + 4 * row, rounded_text(largest / prefix.factor) + " " + prefix.symbol + "m");
}

}  // namespace internal

/// Draws the paths to the scale of the particles, whose shapes now lie below them, in the manner of
/// the paper's Fig. 7. A dot ends the path of every particle that is still there; dotted lines lead
/// from the place of a break to the pieces.
[[nodiscard]] inline Svg displacement_picture(const Particles& particles,
                                              const DisplacementPaths& record,
                                              const std::string& title) {
  const std::vector<Vec2> points = internal::points_of(record);
  const AssemblyView view(particles, points);
  Svg svg = view.canvas();
  view.outlines(svg, particles);
  for (const auto& path : record.paths())
    if (path.branch && !path.points.empty())
      svg.line(view(*path.branch), view(path.points.front()), internal::branch_style);
  // Pieces over the paths of intact particles, dots over all paths.
  for (const bool broken : {false, true})
    for (const auto& path : record.paths())
      if (!path.points.empty() && (path.particle.generation > 0) == broken)
        svg.polyline(view(path.points), internal::path_style(path.particle));
  for (const bool broken : {false, true})
    for (BodyIndex i = 0; i < particles.size(); ++i) {
      const Ancestry& particle = particles.ancestry(i);
      if (!particles.body(i).is_wall() && (particle.generation > 0) == broken)
        svg.circle(view(particles.body(i).position), internal::path_dot,
                   internal::dot_style(particle));
    }
  view.annotate(svg, title);
  internal::displacement_legend(svg, {view.legend_left() + 14, 70},
                                internal::largest_displacement(record));
  return svg;
}

}  // namespace riprap
