#pragma once
/// @file
/// Line charts with axes, units and a legend.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <riprap/output/svg.hpp>

namespace riprap {

/// One curve of a chart.
struct Series {
  std::string name;
  std::vector<Vec2> points;
  std::string colour = "#1f6fb4";
  bool dashed = false;
};

/// A chart; the axes end on round numbers.
struct Chart {
  std::string title;
  std::string x_label;
  std::string y_label;
  std::vector<Series> series;

  /// Draws into a rectangle of a picture.
  void draw(Svg& svg, const Vec2& corner, const Vec2& size) const {
    const Axis x = axis(0);
    const Axis y = axis(1);
    const Vec2 low = corner + Vec2{margin_left, size.y() - margin_bottom};
    const Vec2 high = corner + Vec2{size.x() - margin_right, margin_top};
    const auto at = [&](const Vec2& v) -> Vec2 {
      return {low.x() + (v.x() - x.low) / (x.high - x.low) * (high.x() - low.x()),
              low.y() + (v.y() - y.low) / (y.high - y.low) * (high.y() - low.y())};
    };
    draw_axes(svg, x, y, low, high, at);
    svg.text({0.5 * (low.x() + high.x()), corner.y() + 20}, title, "middle", 15);
    svg.text({0.5 * (low.x() + high.x()), corner.y() + size.y() - 12}, x_label, "middle");
    svg.text({corner.x() + 18, 0.5 * (low.y() + high.y())}, y_label, "middle", 13, -90);

    double row = high.y() + 16;
    for (const Series& s : series) {
      const std::string style = "fill=\"none\" stroke=\"" + s.colour + "\" stroke-width=\"1.8\"" +
                                (s.dashed ? " stroke-dasharray=\"6 4\"" : "");
      std::vector<Vec2> placed;
      placed.reserve(s.points.size());
      for (const Vec2& p : s.points) placed.push_back(at(p));
      svg.polyline(placed, style);
      if (s.name.empty()) continue;
      const double left = high.x() + 12;
      svg.line({left, row - 4}, {left + 26, row - 4}, style);
      svg.text({left + 32, row}, s.name, "start", 12);
      row += 18;
    }
  }

 private:
  static constexpr double margin_left = 68;
  static constexpr double margin_right = 150;
  static constexpr double margin_top = 34;
  static constexpr double margin_bottom = 52;

  struct Axis {
    double low = 0;
    double high = 1;
    double tick = 0.2;
  };

  [[nodiscard]] Axis axis(Eigen::Index which) const {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Series& s : series)
      for (const Vec2& p : s.points) {
        low = std::min(low, p[which]);
        high = std::max(high, p[which]);
      }
    if (!(low < high)) {
      low = std::isfinite(low) ? low - 0.5 : 0;
      high = low + 1;
    }
    const double raw = (high - low) / 5;
    const double decade = std::pow(10, std::floor(std::log10(raw)));
    double tick = 10 * decade;
    for (const double step : {5.0, 2.0, 1.0})
      if (step * decade >= raw) tick = step * decade;
    // A hair beyond a tick does not ask for another one.
    return {tick * std::floor(low / tick + 0.02), tick * std::ceil(high / tick - 0.02), tick};
  }

  template <class Place>
  static void draw_axes(Svg& svg, const Axis& x, const Axis& y, const Vec2& low, const Vec2& high,
                        const Place& at) {
    constexpr auto grid = "stroke=\"#ddd\" stroke-width=\"1\"";
    constexpr auto zero = "stroke=\"#888\" stroke-width=\"1\"";
    for (int k = 0; x.low + k * x.tick <= x.high + 0.01 * x.tick; ++k) {
      const double v = x.low + k * x.tick;
      const double px = at({v, y.low}).x();
      svg.line({px, low.y()}, {px, high.y()}, grid);
      svg.text({px, low.y() + 18}, label(v, x.tick), "middle", 12);
    }
    for (int k = 0; y.low + k * y.tick <= y.high + 0.01 * y.tick; ++k) {
      const double v = y.low + k * y.tick;
      const double py = at({x.low, v}).y();
      svg.line({low.x(), py}, {high.x(), py}, std::abs(v) < 0.01 * y.tick ? zero : grid);
      svg.text({low.x() - 8, py + 4}, label(v, y.tick), "end", 12);
    }
    svg.rectangle({low.x(), high.y()}, {high.x() - low.x(), low.y() - high.y()},
                  "fill=\"none\" stroke=\"#444\"");
  }

  // As many decimals as the tick needs.
  [[nodiscard]] static std::string label(double value, double tick) {
    const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(tick) - 1e-9)));
    if (std::abs(value) < 1e-6 * tick) value = 0;
    char buffer[64];
    const auto end =
        std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, decimals)
            .ptr;
    return {buffer, end};
  }
};

/// Several charts in rows of two.
[[nodiscard]] inline Svg chart_sheet(const std::vector<Chart>& charts) {
  constexpr double width = 600;
  constexpr double height = 380;
  const std::size_t rows = (charts.size() + 1) / 2;
  Svg svg(charts.size() > 1 ? 2 * width : width, height * static_cast<double>(rows));
  for (std::size_t i = 0; i < charts.size(); ++i) {
    const std::size_t row = i / 2;
    const std::size_t column = i % 2;
    charts[i].draw(svg, {width * static_cast<double>(column), height * static_cast<double>(row)},
                   {width, height});
  }
  return svg;
}

}  // namespace riprap
