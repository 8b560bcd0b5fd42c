// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A picture of the contact forces: lines from centroid to centroid, in classes of normal force.

#include <cmath>
#include <string>

#include <riprap/output/assembly_view.hpp>
#include <riprap/output/force_classes.hpp>

namespace riprap {

namespace internal {

/// From thin and pale for the weakest class to thick and dark for the strongest.
[[nodiscard]] inline std::string force_class_stroke(std::size_t k, std::size_t classes) {
  const double share = static_cast<double>(k) / static_cast<double>(classes - 1);
  return "stroke=\"hsl(4,70%," + Svg::number(74 - 46 * share) +
         "%)\" stroke-linecap=\"round\" stroke-width=\"" + Svg::number(0.7 + 5.3 * share) + "\"";
}

}  // namespace internal

/// Draws particles as outlines and normal forces as lines, the strongest class on top, in the
/// manner of the paper's Fig. 11. Forces that are not a number are left out.
/// @throws InvalidInput if the classes are not in order
template <class Contacts>
[[nodiscard]] Svg force_chain_picture(const Particles& particles, const Contacts& contacts,
                                      const std::string& title, const ForceClasses& classes = {}) {
  classes.validate();
  const AssemblyView view(particles);
  Svg svg = view.canvas();
  view.outlines(svg, particles);

  for (std::size_t k = 0; k < classes.size(); ++k) {
    const std::string style = internal::force_class_stroke(k, classes.size());
    contacts.for_each_touching([&](const auto& c) {
      // Zero where particles just touch.
      if (c.force.normal == 0 || classes(c.force.normal) != k) return;
      if (std::isnan(c.force.normal)) return svg.leave_out();
      // A half in each particle: a chain runs through the particles it loads. Across a periodic
      // cell each half stays with its own; a wall has none.
      const auto half = [&](BodyIndex i, const Vec2& arm) {
        const Vec2& centroid = particles.body(i).position;
        if (!arm.isZero()) svg.line(view(centroid), view(centroid + arm), style);
      };
      half(c.a, c.branch_arm_a());
      half(c.b, c.branch_arm_b());
    });
  }

  view.annotate(svg, title);
  const double left = view.legend_left() + 14;
  double row = 70;
  svg.text({left, row}, "normal force");
  for (std::size_t k = 0; k < classes.size(); ++k) {
    row += 24;
    svg.line({left, row - 5}, {left + 30, row - 5},
             internal::force_class_stroke(k, classes.size()));
    svg.text({left + 42, row}, classes.name(k));
  }
  return svg;
}

}  // namespace riprap
