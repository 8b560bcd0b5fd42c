// SPDX-License-Identifier: BSL-1.0
#include "panels.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace {

using riprap::Vec2;

constexpr double side = 300;   // of a panel, without its title
constexpr double header = 34;  // for the title
constexpr double margin = 12;

struct Box {
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 high = -low;

  explicit Box(const ShapePanel& panel) {
    for (const riprap::ConvexPolygon& polygon : panel.polygons)
      for (const Vec2& v : polygon) {
        low = riprap::componentwise_min(low, v);
        high = riprap::componentwise_max(high, v);
      }
  }
  [[nodiscard]] double size() const { return std::max(high.x() - low.x(), high.y() - low.y()); }
};

void draw(riprap::Svg& svg, const ShapePanel& panel, const Vec2& corner, const Box& box,
          double scale) {
  constexpr std::array fills{"#e8c37e", "#9dc1dd", "#a9cf9f", "#d7b3e0", "#e6a7a0", "#cfcab2"};
  const Vec2 middle = corner + Vec2{0.5 * side + margin, header + 0.5 * side};
  const Vec2 centre = box.low + 0.5 * (box.high - box.low);
  svg.text(corner + Vec2{0.5 * side + margin, 22}, panel.title, "middle", 15);
  for (std::size_t k = 0; k < panel.polygons.size(); ++k) {
    std::vector<Vec2> placed;
    for (const Vec2& v : panel.polygons[k])
      placed.push_back(middle + Vec2{scale * (v.x() - centre.x()), scale * (centre.y() - v.y())});
    svg.polygon(placed, std::string("fill=\"") + fills[k % fills.size()] +
                            "\" stroke=\"#444\" stroke-width=\"0.8\" stroke-linejoin=\"round\"");
  }
}

}  // namespace

riprap::Svg shape_panels(const std::vector<ShapePanel>& panels, std::size_t columns,
                         bool same_scale) {
  const double width = side + 2 * margin;
  const double height = side + header + margin;
  const std::size_t rows = (panels.size() + columns - 1) / columns;
  riprap::Svg svg(width * static_cast<double>(columns), height * static_cast<double>(rows));
  double largest = 0;
  for (const ShapePanel& panel : panels) largest = std::max(largest, Box(panel).size());
  for (std::size_t k = 0; k < panels.size(); ++k) {
    const Box box(panels[k]);
    const std::size_t row = k / columns;
    const Vec2 corner{width * static_cast<double>(k % columns), height * static_cast<double>(row)};
    draw(svg, panels[k], corner, box, side / (same_scale ? largest : box.size()));
  }
  return svg;
}
