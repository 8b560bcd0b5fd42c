// SPDX-License-Identifier: BSL-1.0
#include "shot_picture.hpp"

#include <array>

riprap::Svg shot_picture(const std::vector<ShotPanel>& panels, double diameter) {
  using riprap::Vec2;
  constexpr double width = 480;
  constexpr double height = 330;
  constexpr double plate = 290;  // pixels down to it
  constexpr std::array fills{"#7fb2d8", "#f2a541", "#8cc084", "#c9a0dc", "#e58a8a", "#d9c27a"};
  const double scale = width / (8 * diameter);
  const std::size_t rows = (panels.size() + 1) / 2;
  riprap::Svg svg(2 * width, height * static_cast<double>(rows));
  for (std::size_t k = 0; k < panels.size(); ++k) {
    const Vec2 corner{k % 2 == 0 ? 0 : width, height * static_cast<double>(k / 2)};
    svg.text(corner + Vec2{0.5 * width, 26}, panels[k].title, "middle", 15);
    svg.rectangle(corner + Vec2{12, plate}, {width - 24, 14}, "fill=\"#8d949c\"");
    const auto draw = [&](const Outlines& rings, double middle) {
      for (std::size_t i = 0; i < rings.size(); ++i) {
        std::vector<Vec2> placed;
        for (const Vec2& v : rings[i])
          placed.push_back(corner + Vec2{middle + scale * v.x(), plate - scale * v.y()});
        svg.polygon(placed, std::string("fill=\"") +
                                (rings.size() == 1 ? "#efe9dc" : fills[i % fills.size()]) +
                                "\" stroke=\"#444\" stroke-width=\"0.8\"");
      }
    };
    draw(panels[k].before, 0.2 * width);
    draw(panels[k].after, 0.62 * width);
    svg.text(corner + Vec2{0.2 * width, 322}, "before", "middle", 12);
    svg.text(corner + Vec2{0.62 * width, 322}, "1 ms after", "middle", 12);
  }
  return svg;
}
