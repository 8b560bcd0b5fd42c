// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A picture of local strain: the triangles between centroids, and the band of the largest strains.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <string>

#include <riprap/core/errors.hpp>
#include <riprap/measurement/local_strain.hpp>
#include <riprap/measurement/strain_localisation.hpp>
#include <riprap/output/assembly_view.hpp>

namespace riprap {

namespace internal {

inline constexpr int strain_classes = 10;  // of colour

[[nodiscard]] inline std::string strain_colour(int k) {
  const int light = 92 - 7 * k;
  const int hue = (390 - 10 * k) % 360;  // from sand to violet
  return "hsl(" + std::to_string(hue) + ",55%," + std::to_string(light) + "%)";
}
[[nodiscard]] inline int strain_class(double strain, double full_strain) {
  const double share = std::clamp(strain / full_strain, 0.0, 1.0);
  return std::min(static_cast<int>(share * strain_classes), strain_classes - 1);
}

/// The rectangle of the thickness and the length of a band.
[[nodiscard]] inline std::array<Vec2, 4> band_outline(const StrainLocalisation& band) {
  const Vec2 along{std::cos(band.direction), std::sin(band.direction)};
  const Vec2 length = 0.5 * band.elongation * band.thickness * along;
  const Vec2 width = 0.5 * band.thickness * perpendicular(along);
  return {band.centre + length + width, band.centre - length + width, band.centre - length - width,
          band.centre + length - width};
}

inline void strain_legend(Svg& svg, const Vec2& corner, double full_strain,
                          const StrainLocalisation& band) {
  svg.text(corner, "deviatoric strain");
  constexpr double cell = 15;
  for (int k = 0; k < strain_classes; ++k)
    svg.rectangle(corner + Vec2{cell * k, 12}, {cell, 14}, "fill=\"" + strain_colour(k) + "\"");
  const double end = cell * strain_classes;
  svg.text(corner + Vec2{0, 42}, "0");
  svg.text(corner + Vec2{end, 42}, rounded_text(100 * full_strain) + " % and more", "end");
  Vec2 at = corner + Vec2{0, 56};
  const auto line = [&](const std::string& text) {
    at += Vec2{0, 22};
    svg.text(at, text);
  };
  line("band: " + std::to_string(std::lround(band.direction * 180 / std::numbers::pi)) +
       " degrees to axis 1,");
  line(rounded_text(std::round(10 * band.elongation) / 10) + " times as long as thick");
  line(std::to_string(std::lround(100 * band.band_share)) + " % of the strain in it");
  line("most strained tenth: " + std::to_string(std::lround(100 * band.strain_share)) + " %");
  line("participation ratio " + rounded_text(std::round(100 * band.participation_ratio) / 100));
}

}  // namespace internal

/// Draws triangles in the reference state, coloured by their deviatoric strain, below the outlines
/// of the particles of that state, and the band as a rectangle of its thickness and length.
/// @param reference particles in the reference state
/// @param full_strain of the darkest colour [-]
/// Throws InvalidInput unless `full_strain` is above 0.
[[nodiscard]] inline Svg local_strain_picture(const Particles& reference,
                                              std::span<const StrainTriangle> triangles,
                                              const StrainLocalisation& band, double full_strain,
                                              const std::string& title) {
  require_positive("local_strain_picture: full_strain", full_strain);
  const AssemblyView view(reference);
  Svg svg = view.canvas();
  for (int k = 0; k < internal::strain_classes; ++k) {
    const std::string colour = "\"" + internal::strain_colour(k) + "\"";
    const std::string style = "fill=" + colour + " stroke=" + colour + " stroke-width=\"0.6\"";
    for (const StrainTriangle& t : triangles)
      if (internal::strain_class(t.gradient.deviatoric_strain(), full_strain) == k)
        svg.polygon(view(t.corners), style);
  }
  for (BodyIndex i = 0; i < reference.size(); ++i)
    svg.polygon(view(reference.ring(i)),
                R"(fill="none" stroke="#333" stroke-opacity="0.45" stroke-width="0.6")");
  svg.polygon(view(internal::band_outline(band)),
              R"(fill="none" stroke="#0b4f8a" stroke-width="2.5" stroke-dasharray="9 5")");
  view.annotate(svg, title);
  internal::strain_legend(svg, {view.legend_left() + 14, 70}, full_strain, band);
  return svg;
}

}  // namespace riprap
