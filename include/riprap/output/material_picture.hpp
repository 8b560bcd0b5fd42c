// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A picture of all particles in the colours of their rocks.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include <riprap/output/assembly_view.hpp>

namespace riprap {

namespace internal {

/// Of intact particles and of pieces of a material; the seventh has those of the first again.
[[nodiscard]] inline std::string material_colour(MaterialIndex material, bool broken) {
  struct Pair {
    const char* intact;
    const char* broken;
  };
  static constexpr std::array<Pair, 6> colours{{{"#e6d3a8", "#b0803a"},
                                                {"#a9c6d9", "#2f6f9f"},
                                                {"#b9d3a4", "#4f8a3a"},
                                                {"#dcb6c8", "#a03f6d"},
                                                {"#c9bfe0", "#6a4fa5"},
                                                {"#cfcfcf", "#6f6f6f"}}};
  const Pair& pair = colours[material % colours.size()];
  return broken ? pair.broken : pair.intact;
}

}  // namespace internal

/// Draws every particle in the colour of its material, intact ones pale and pieces dark; walls and
/// platens in the grey of a boundary, whatever their material.
/// @param names of the materials; those without one are called by their number
[[nodiscard]] inline Svg material_picture(const Particles& particles,
                                          const std::vector<std::string>& names,
                                          const std::string& title) {
  const AssemblyView view(particles);
  Svg svg = view.canvas();
  const std::string outline = "\" stroke=\"#555\" stroke-width=\"0.5\" stroke-linejoin=\"round\"";
  bool has_walls = false;
  for (BodyIndex i = 0; i < particles.size(); ++i) {
    const bool is_wall = particles.body(i).is_wall();
    const bool broken = particles.ancestry(i).generation > 0;
    const std::string colour = is_wall ? internal::boundary_colour
                                       : internal::material_colour(particles.material(i), broken);
    svg.polygon(view(particles.ring(i)), "fill=\"" + colour + outline);
    has_walls |= is_wall;
  }
  view.annotate(svg, title);
  const double left = view.legend_left() + 14;
  double row = 70;
  const auto patch = [&](const std::string& colour, const std::string& name) {
    svg.rectangle({left, row - 12}, {18, 14}, "fill=\"" + colour + outline);
    svg.text({left + 26, row}, name);
    row += 24;
  };
  for (std::size_t m = 0; m < particles.materials(); ++m) {
    const auto material = static_cast<MaterialIndex>(m);
    const std::string name = m < names.size() ? names[m] : "material " + std::to_string(m);
    patch(internal::material_colour(material, false), name);
    patch(internal::material_colour(material, true), name + ": pieces");
  }
  if (has_walls) patch(internal::boundary_colour, "boundary");
  return svg;
}

}  // namespace riprap
