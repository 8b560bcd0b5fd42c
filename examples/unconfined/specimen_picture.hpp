// SPDX-License-Identifier: BSL-1.0
#pragma once
// The specimen: safety factors, failed elements and the lines through them; counterpart of Fig. 3.

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include <riprap/output/svg.hpp>

#include "study.hpp"

namespace unconfined {

// One specimen upright in the picture, in pixels.
class SpecimenPanel {
 public:
  SpecimenPanel(riprap::Svg& svg, const Specimen& s, double middle)
      : svg_(svg), specimen_(s), middle_(middle) {
    const double height = s.options.aspect * s.options.width;
    scale_ = std::min(560 / height, 330 / s.options.width);
    draw_platens();
  }

  [[nodiscard]] riprap::Vec2 at(const riprap::Vec2& x) const {
    return {middle_ + scale_ * x.x(), 360 - scale_ * x.y()};
  }
  [[nodiscard]] riprap::Vec2 half_size() const {
    return 0.5 * specimen_.options.width * riprap::Vec2{1, specimen_.options.aspect};
  }

  void element(std::size_t e, const std::string& colour) {
    std::vector<riprap::Vec2> corners;
    for (const auto& x : specimen_.result.mesh.triangle(e)) corners.push_back(at(x));
    svg_.polygon(corners, "fill=\"" + colour + "\" stroke=\"#999\" stroke-width=\".4\"");
  }

  void outline(const std::string& fill) {
    const riprap::Vec2 half = half_size();
    svg_.rectangle(at({-half.x(), half.y()}), 2 * scale_ * half,
                   "fill=\"" + fill + "\" stroke=\"#222\" stroke-width=\"1.4\"");
  }

  // The part of the line within the specimen.
  void line(const riprap::Line& line, const std::string& style) {
    const riprap::Vec2 half = half_size();
    double first = -1e9;
    double last = 1e9;
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
      const double direction = line.direction[axis];
      if (direction == 0) continue;
      const double a = (-half[axis] - line.point[axis]) / direction;
      const double b = (half[axis] - line.point[axis]) / direction;
      first = std::max(first, std::min(a, b));
      last = std::min(last, std::max(a, b));
    }
    if (first < last)
      svg_.line(at(line.point + first * line.direction), at(line.point + last * line.direction),
                style);
  }

 private:
  void draw_platens() {
    const riprap::Vec2 half = half_size();
    const riprap::Vec2 size{2 * scale_ * half.x() + 30, 14};
    svg_.rectangle(at({-half.x(), half.y()}) - riprap::Vec2{15, 14}, size, "fill=\"#888\"");
    svg_.rectangle(at(-half) - riprap::Vec2{15, 0}, size, "fill=\"#888\"");
  }

  riprap::Svg& svg_;
  const Specimen& specimen_;
  double middle_;
  double scale_ = 1;
};

// Upper ends of the classes of safety factors; up to 1 an element has failed.
inline constexpr std::array class_ends{0.96, 0.98, 1.0, 1.02, 1.05, 1.1};
inline constexpr std::array class_colours{"#7f0000", "#d7301f", "#fc8d59", "#fdf0c8",
                                          "#c6dbef", "#7fb2d8", "#3b7bb5"};
inline constexpr std::array line_styles{
    "stroke=\"#1f6fb4\" stroke-width=\"3\"",
    "stroke=\"#15803d\" stroke-width=\"2\" stroke-dasharray=\"8 5\"",
    "stroke=\"#d11141\" stroke-width=\"2.2\" stroke-dasharray=\"3 4\""};

inline std::string with_digits(const char* format, double value) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}

inline void draw_safety_factors(riprap::Svg& svg, const Specimen& s) {
  SpecimenPanel panel(svg, s, 200);
  for (std::size_t e = 0; e < s.result.mesh.size(); ++e) {
    const auto end = std::ranges::lower_bound(class_ends, s.result.elements[e].safety_factor);
    panel.element(e, class_colours[static_cast<std::size_t>(end - class_ends.begin())]);
  }
  panel.outline("none");
  svg.text({30, 690}, "safety factor, failed up to 1:", "start", 12);
  for (std::size_t k = 0; k < class_colours.size(); ++k) {
    const riprap::Vec2 corner{30 + 56 * static_cast<double>(k), 700};
    svg.rectangle(corner, {56, 12}, "fill=\"" + std::string(class_colours[k]) + "\"");
    if (k < class_ends.size())
      svg.text(corner + riprap::Vec2{56, 28}, riprap::to_text(class_ends[k]), "middle", 12);
  }
}

inline void draw_failed(riprap::Svg& svg, const Specimen& s) {
  SpecimenPanel panel(svg, s, 640);
  panel.outline("#f1ede4");
  for (std::size_t e = 0; e < s.result.mesh.size(); ++e)
    if (s.result.elements[e].failed())
      panel.element(e, s.result.elements[e].mode == riprap::FailureMode::tension ? "#f2a541"
                                                                                 : "#a06cc0");
  if (s.result.failures.failed > 0) {
    std::vector<riprap::Vec2> first;
    for (const auto& x : s.result.mesh.triangle(s.result.failures.first_failed))
      first.push_back(panel.at(x));
    svg.polygon(first, "fill=\"none\" stroke=\"#000\" stroke-width=\"2.4\"");
  }
  double row = 690;
  for (std::size_t k = 0; k < s.lines.size(); ++k, row += 17) {
    panel.line(s.lines[k].line, line_styles[k]);
    svg.line({430, row - 4}, {460, row - 4}, line_styles[k]);
    svg.text({468, row},
             s.lines[k].fit + with_digits(": %.0f degrees to the axis", s.lines[k].angle()),
             "start", 12);
  }
}

// Drawn in a coarser mesh than the numbers are computed in: a smaller file, and one can see the
// elements.
inline riprap::Svg draw_specimen(const Study& study) {
  Options coarse = study.options;
  coarse.triangles = std::min(coarse.triangles, 800u);
  const Specimen s = specimen(coarse);
  riprap::Svg svg(860, 750);
  svg.text({430, 24},
           std::to_string(s.result.failures.elements) + " triangles at a mean platen stress of " +
               with_digits("%g", s.options.load) +
               " times the strength: Rat = " + with_digits("%.2f", s.result.ratio()),
           "middle", 16);
  svg.text({200, 50}, "safety factors", "middle", 14);
  svg.text({640, 50},
           std::to_string(s.result.shear) + " failed in shear (purple), " +
               std::to_string(s.result.tensile) + " in tension; first one outlined",
           "middle", 14);
  draw_safety_factors(svg, s);
  draw_failed(svg, s);
  return svg;
}

}  // namespace unconfined
