// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A picture of a number for every particle, as a dot on each.

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <riprap/output/assembly_view.hpp>

namespace riprap {

/// What the dots of a picture stand for.
struct DotLegend {
  std::string quantity{};         ///< such as "contacts"
  std::vector<double> samples{};  ///< values that the legend shows, ascending
  /// The value whose dot is as wide as a square of a mean particle's area.
  double full_value = 1;
  /// From here on dots have the colour of a warning, and the legend says so.
  double critical = std::numeric_limits<double>::infinity();
};

namespace internal {

[[nodiscard]] inline const char* dot_ink(double value, const DotLegend& legend) {
  return value >= legend.critical ? "fill=\"#c0392b\"" : "fill=\"#1f4e79\"";
}

}  // namespace internal

/// Draws particles as outlines and on each a dot whose diameter is proportional to its value, in
/// the manner of the paper's Figs 8 and 13.
/// @param values of every particle in the order of the bodies; none has a dot for zero or less, nor
///               for not-a-number
[[nodiscard]] inline Svg dot_picture(const Particles& particles, const std::vector<double>& values,
                                     const DotLegend& legend, const std::string& title) {
  require_positive("DotLegend.full_value", legend.full_value);
  const AssemblyView view(particles);
  Svg svg = view.canvas();
  view.outlines(svg, particles);
  double mean_width = 0;
  for (BodyIndex i = 0; i < particles.size(); ++i)
    mean_width += std::sqrt(particles.shape(i).area) / static_cast<double>(particles.size());
  const double unit = 0.5 * mean_width * view.scale() / legend.full_value;
  // The critical ones over the others.
  for (const bool critical : {false, true})
    for (std::size_t i = 0; i < values.size(); ++i)
      if (values[i] > 0 && (values[i] >= legend.critical) == critical)
        svg.circle(view(particles.body(static_cast<BodyIndex>(i)).position), unit * values[i],
                   internal::dot_ink(values[i], legend));

  view.annotate(svg, title);
  const double left = view.legend_left() + 14;
  double row = 70;
  svg.text({left, row}, legend.quantity);
  for (const double value : legend.samples) {
    row += 26;
    svg.circle({left + 14, row - 5}, unit * value, internal::dot_ink(value, legend));
    svg.text({left + 36, row}, to_text(value));
  }
  if (std::isfinite(legend.critical)) {
    row += 26;
    svg.text({left, row}, "red: " + to_text(legend.critical) + " or more");
  }
  return svg;
}

}  // namespace riprap
