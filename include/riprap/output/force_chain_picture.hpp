#pragma once
/// @file
/// A picture of the contact forces: a line from centroid to centroid, as wide as the normal force
/// is large.

#include <algorithm>
#include <cmath>
#include <string>

#include <riprap/output/assembly_view.hpp>

namespace riprap {

/// Draws particles as outlines and normal forces as lines; widths are to the scale of the legend.
template <class Contacts>
[[nodiscard]] Svg force_chain_picture(const Particles& particles, const Contacts& contacts,
                                      const std::string& title) {
  const AssemblyView view(particles);
  Svg svg = view.canvas();
  for (BodyIndex i = 0; i < particles.size(); ++i)
    svg.polygon(view(particles.ring(i)), std::string("fill=\"") +
                                             (particles.body(i).is_free() ? "#faf7f0" : "#e3e5e8") +
                                             "\" stroke=\"#c9c4b8\" stroke-width=\"0.5\"");

  double mean = 0;
  std::size_t count = 0;
  contacts.for_each_touching([&](const auto& c) {
    mean += c.force.normal;
    ++count;
  });
  if (count > 0) mean /= static_cast<double>(count);
  constexpr double width_of_mean = 2.2;  // pixels
  const auto stroke = [&](double force) {
    return "stroke=\"#a3201d\" stroke-linecap=\"round\" stroke-width=\"" +
           Svg::number(width_of_mean * force / mean) + "\"";
  };
  contacts.for_each_touching([&](const auto& c) {
    if (c.force.normal == 0) return;  // particles that just touch
    // Half by half through the contact point: a chain runs through the particles it loads.
    const std::string style = stroke(c.force.normal);
    svg.line(view(c.geometry.point - c.arm_a), view(c.geometry.point), style);
    svg.line(view(c.geometry.point), view(c.geometry.point - c.arm_b), style);
  });

  view.annotate(svg, title);
  const double left = view.legend_left() + 14;
  svg.text({left, 70}, "normal force");
  if (mean > 0) {
    // A round force near the mean, and multiples of it.
    const double decade = std::pow(10, std::floor(std::log10(mean)));
    const double unit = decade * std::max(1.0, std::round(mean / decade));
    double row = 70;
    for (const double multiple : {0.5, 1.0, 2.0, 4.0}) {
      row += 26;
      svg.line({left, row - 5}, {left + 40, row - 5}, stroke(multiple * unit));
      svg.text({left + 52, row}, to_text(multiple * unit) + " N");
    }
  }
  return svg;
}

}  // namespace riprap
