// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A picture of how far particles have come since a moment: an arrow for each.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <riprap/experiment/incremental_displacement.hpp>
#include <riprap/output/assembly_view.hpp>

namespace riprap {

namespace internal {

[[nodiscard]] inline const char* move_colour(bool is_free) {
  return is_free ? "#1f4e79" : boundary_colour;
}

/// Arrows from where to where, in pixels; a head is a third of a short arrow and never long.
inline void arrows(Svg& svg, const std::vector<std::array<Vec2, 2>>& all,
                   const std::string& colour) {
  std::vector<std::array<Vec2, 3>> heads;
  for (const auto& [from, to] : all) {
    const double length = (to - from).norm();
    if (length < 0.5) continue;
    if (!std::isfinite(length)) {
      svg.leave_out();
      continue;
    }
    const Vec2 along = (to - from) / length;
    const double head = std::min(7.0, 0.35 * length);
    const Vec2 neck = to - head * along;
    const Vec2 across = 0.4 * head * perpendicular(along);
    heads.push_back({to, neck + across, neck - across});
    svg.line(from, neck, "stroke=\"" + colour + "\"");
  }
  for (const auto& head : heads) svg.polygon(head, "fill=\"" + colour + "\"");
}

}  // namespace internal

/// Draws every move as an arrow to the scale of the particles, whose shapes now lie below, in the
/// manner of the paper's Fig. 10.
[[nodiscard]] inline Svg movement_picture(const Particles& particles,
                                          const std::vector<Move>& moves,
                                          const std::string& title) {
  std::vector<Vec2> ends;
  double largest = 0;
  for (const Move& move : moves) {
    ends.push_back(move.from);
    ends.push_back(move.to);
    if (move.is_free) largest = std::max(largest, (move.to - move.from).norm());
  }
  const AssemblyView view(particles, ends);
  Svg svg = view.canvas();
  view.outlines(svg, particles);
  for (const bool is_free : {false, true}) {
    std::vector<std::array<Vec2, 2>> all;
    for (const Move& move : moves)
      if (move.is_free == is_free) all.push_back({view(move.from), view(move.to)});
    internal::arrows(svg, all, internal::move_colour(is_free));
  }

  view.annotate(svg, title);
  const double left = view.legend_left() + 14;
  double row = 70;
  for (const bool is_free : {true, false}) {
    internal::arrows(svg, {{Vec2{left, row - 5}, Vec2{left + 28, row - 5}}},
                     internal::move_colour(is_free));
    svg.text({left + 38, row}, is_free ? "free particle" : "boundary");
    row += 24;
  }
  const UnitPrefix prefix = unit_prefix(largest);
  svg.text({left, row + 12}, "longest, of a free one:");
  svg.text({left, row + 30}, rounded_text(largest / prefix.factor) + " " + prefix.symbol + "m");
  return svg;
}

}  // namespace riprap
