// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A picture of a bonded sample: fragments, live and broken bonds.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <riprap/measurement/fragments.hpp>
#include <riprap/output/assembly_picture.hpp>
#include <riprap/output/bonds_vtp.hpp>

namespace riprap {

/// Draws every particle in the colour of its fragment (driven ones grey, those of one body pale),
/// live bonds as thin lines along their edges, and broken ones in red (tension) or blue (shear)
/// where the edge is now.
template <class Sim>
[[nodiscard]] Svg bond_picture(const Sim& sim, const std::string& title) {
  const Particles& particles = sim.particles();
  const AssemblyView view(particles);
  Svg svg = view.canvas();
  const std::string outline = " stroke=\"#888\" stroke-width=\"0.3\"";
  const std::vector<std::uint32_t> numbers = fragment_numbers(sim);
  std::vector<std::size_t> sizes(numbers.size(), 0);
  for (const std::uint32_t number : numbers) ++sizes[number];
  for (BodyIndex i = 0; i < particles.size(); ++i) {
    const std::string colour = !particles.body(i).is_free() ? internal::boundary_colour
                               : sizes[numbers[i]] == 1     ? "#efe9dc"
                                                            : internal::family_colour(numbers[i]);
    svg.polygon(view(particles.ring(i)), "fill=\"" + colour + "\"" + outline);
  }
  const auto draw = [&](const std::array<Vec2, 2>& ends, const std::string& style) {
    svg.line(view(ends[0]), view(ends[1]), style);
  };
  const std::string live = R"(stroke="#222" stroke-width="0.8")";
  const std::string tension = R"(stroke="#d62728" stroke-width="1.6")";
  const std::string shear = R"(stroke="#1f4fd6" stroke-width="1.6")";
  for (const auto& bond : sim.bonds()) draw(bond.ends(particles.body(bond.a)), live);
  for (const BondBreak& broken : sim.bond_breaks())
    if (const auto edge = edge_now(broken, particles))
      draw(*edge, broken.failure == BondFailure::shear ? shear : tension);
  view.annotate(svg, title);
  const double left = view.legend_left() + 14;
  double row = 70;
  const auto entry = [&](const std::string& style, const std::string& name) {
    svg.line({left, row - 5}, {left + 18, row - 5}, style);
    svg.text({left + 26, row}, name);
    row += 24;
  };
  entry(live, "bond");
  entry(tension, "broken, tension");
  entry(shear, "broken, shear");
  svg.text({left, row}, "a colour for each fragment");
  return svg;
}

}  // namespace riprap
