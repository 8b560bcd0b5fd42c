// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A picture of all particles: families of pieces in colours, failed shares as dots.

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <riprap/output/assembly_view.hpp>

namespace riprap {

namespace internal {

/// A colour for every family, far from that of the next ids.
[[nodiscard]] inline std::string family_colour(ParticleId root) {
  // Hues by the golden angle keep neighbours in the count apart.
  const double hue = std::fmod(137.508 * root, 360);
  const int lightness = 52 + 9 * static_cast<int>(root % 3);
  return "hsl(" + Svg::number(hue) + ",62%," + std::to_string(lightness) + "%)";
}

}  // namespace internal

/// Draws every particle: boundary particles dark, intact ones pale, all pieces of one intact
/// particle in one colour; a dot shows the share Rat of failed elements by its size.
/// @param ratios Rat of every particle in the order of the bodies, or empty for no dots; none has a
///               dot for less than 0.01, nor for not-a-number
[[nodiscard]] inline Svg assembly_picture(const Particles& particles,
                                          const std::vector<double>& ratios,
                                          const std::string& title) {
  const AssemblyView view(particles);
  Svg svg = view.canvas();
  const std::string outline = " stroke=\"#555\" stroke-width=\"0.5\" stroke-linejoin=\"round\"";
  // What has one colour is drawn together: the boundary, intact particles, family by family.
  std::map<ParticleId, std::vector<BodyIndex>> families;
  std::array<std::vector<BodyIndex>, 2> others;
  for (BodyIndex i = 0; i < particles.size(); ++i) {
    const Ancestry& ancestry = particles.ancestry(i);
    const bool is_free = particles.body(i).is_free();
    if (is_free && ancestry.generation > 0)
      families[ancestry.root].push_back(i);
    else
      others[is_free].push_back(i);
  }
  const auto draw = [&](const std::vector<BodyIndex>& bodies, const std::string& colour) {
    for (const BodyIndex i : bodies)
      svg.polygon(view(particles.ring(i)), "fill=\"" + colour + "\"" + outline);
  };
  draw(others[0], internal::boundary_colour);
  draw(others[1], "#efe9dc");
  for (const auto& [root, bodies] : families) draw(bodies, internal::family_colour(root));

  // Dots of Rat = 1 would be as wide as a mean particle's half.
  double mean_radius = 0;
  for (BodyIndex i = 0; i < particles.size(); ++i)
    mean_radius += std::sqrt(particles.shape(i).area) / static_cast<double>(particles.size());
  const double unit = 0.45 * mean_radius * view.scale();
  constexpr auto ink = "fill=\"#111\"";
  for (std::size_t i = 0; i < ratios.size(); ++i)
    if (ratios[i] >= 0.01)
      svg.circle(view(particles.body(static_cast<BodyIndex>(i)).position), unit * ratios[i], ink);

  view.annotate(svg, title);
  const double left = view.legend_left() + 14;
  double row = 70;
  const auto patch = [&](const std::string& colour, const std::string& name) {
    svg.rectangle({left, row - 12}, {18, 14}, "fill=\"" + colour + "\"" + outline);
    svg.text({left + 26, row}, name);
    row += 24;
  };
  patch(internal::boundary_colour, "boundary");
  patch("#efe9dc", "intact");
  patch(internal::family_colour(1), "pieces: a colour");
  svg.text({left + 26, row - 6}, "for each parent");
  row += 22;
  if (!ratios.empty()) {
    svg.text({left, row}, "failed share Rat");
    for (const double ratio : {0.1, 0.2, 0.4}) {
      row += 24;
      svg.circle({left + 10, row - 5}, unit * ratio, ink);
      svg.text({left + 26, row}, to_text(ratio));
    }
  }
  return svg;
}

}  // namespace riprap
