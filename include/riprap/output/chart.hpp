// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Charts of curves and of measured points, with axes, units and a legend.

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/output/chart_axis.hpp>
#include <riprap/output/svg.hpp>

namespace riprap {

/// What stands at every point of a series.
enum class Mark { none, circle, square, triangle };

/// One curve of a chart, or one set of measured points.
struct Series {
  std::string name;
  std::vector<Vec2> points;
  std::string colour = "#1f6fb4";
  bool dashed = false;
  Mark mark = Mark::none;
  bool line = true;                ///< joins the points
  std::vector<double> y_errors{};  ///< half the length of each point's error bar; empty for no bars
};

/// A chart; the axes end on round numbers. Values that have no place on an axis (ChartAxis), such
/// as not-a-number, infinity and on a logarithmic axis zero and less, are left out; the picture
/// says so, and the axes are those of the others.
struct Chart {
  std::string title;
  std::string x_label;
  std::string y_label;
  std::vector<Series> series;
  AxisScale x_scale = AxisScale::linear;
  AxisScale y_scale = AxisScale::linear;

  /// Draws into a rectangle of a picture. Throws InvalidInput if a series has error bars of another
  /// number than its points.
  void draw(Svg& svg, const Vec2& corner, const Vec2& size) const {
    const Frame frame{x_axis(), y_axis(), corner + Vec2{margin_left, size.y() - margin_bottom},
                      corner + Vec2{size.x() - margin_right, margin_top}};
    frame.draw(svg);
    const double middle = 0.5 * (frame.low.x() + frame.high.x());
    svg.text({middle, corner.y() + 20}, title, "middle", 15);
    svg.text({middle, corner.y() + size.y() - 12}, x_label, "middle");
    svg.text({corner.x() + 18, 0.5 * (frame.low.y() + frame.high.y())}, y_label, "middle", 13, -90);
    double row = frame.high.y() + 16;
    for (const Series& s : series) {
      draw_series(svg, s, frame);
      if (s.name.empty()) continue;
      const double left = frame.high.x() + 12;
      if (s.line) svg.line({left, row - 4}, {left + 26, row - 4}, line_style(s));
      draw_mark(svg, s, {left + 13, row - 4});
      svg.text({left + 32, row}, s.name, "start", 12);
      row += 18;
    }
  }

 private:
  static constexpr double margin_left = 68;
  static constexpr double margin_right = 150;
  static constexpr double margin_top = 34;
  static constexpr double margin_bottom = 52;

  // The axes and the pixels of their ends.
  struct Frame {
    ChartAxis x;
    ChartAxis y;
    Vec2 low;
    Vec2 high;

    [[nodiscard]] Vec2 at(const Vec2& v) const {
      return {low.x() + x.share(v.x()) * (high.x() - low.x()),
              low.y() + y.share(v.y()) * (high.y() - low.y())};
    }
    void draw(Svg& svg) const {
      constexpr auto grid = "stroke=\"#ddd\" stroke-width=\"1\"";
      constexpr auto zero = "stroke=\"#888\" stroke-width=\"1\"";
      for (const AxisTick& tick : x.ticks()) {
        const double px = at({tick.value, y.low()}).x();
        svg.line({px, low.y()}, {px, high.y()}, grid);
        svg.text({px, low.y() + 18}, tick.label, "middle", 12);
      }
      for (const AxisTick& tick : y.ticks()) {
        const double py = at({x.low(), tick.value}).y();
        svg.line({low.x(), py}, {high.x(), py}, y.is_zero(tick) ? zero : grid);
        svg.text({low.x() - 8, py + 4}, tick.label, "end", 12);
      }
      svg.rectangle({low.x(), high.y()}, {high.x() - low.x(), low.y() - high.y()},
                    "fill=\"none\" stroke=\"#444\"");
    }
  };

  [[nodiscard]] static double y_error(const Series& s, std::size_t i) {
    return s.y_errors.empty() ? 0 : s.y_errors[i];
  }

  // The least and the largest value that has a place on an axis.
  struct Extent {
    AxisScale scale;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;

    void include(double value) {
      if (!ChartAxis::has_place(scale, value)) return;
      low = std::min(low, value);
      high = std::max(high, value);
    }
    [[nodiscard]] ChartAxis axis() const {
      return scale == AxisScale::linear ? ChartAxis::linear(low, high)
                                        : ChartAxis::logarithmic(low, high);
    }
  };
  [[nodiscard]] ChartAxis x_axis() const {
    Extent extent{x_scale};
    for (const Series& s : series)
      for (const Vec2& p : s.points) extent.include(p.x());
    return extent.axis();
  }
  [[nodiscard]] ChartAxis y_axis() const {
    Extent extent{y_scale};
    for (const Series& s : series) {
      require(s.y_errors.empty() || s.y_errors.size() == s.points.size(),
              "number of error bars of series \"" + s.name + "\"",
              static_cast<double>(s.y_errors.size()), "must be 0 or the number of points");
      for (std::size_t i = 0; i < s.points.size(); ++i) {
        extent.include(s.points[i].y() - y_error(s, i));
        extent.include(s.points[i].y() + y_error(s, i));
      }
    }
    return extent.axis();
  }

  [[nodiscard]] static std::string line_style(const Series& s) {
    return "fill=\"none\" stroke=\"" + s.colour + "\" stroke-width=\"1.8\"" +
           (s.dashed ? " stroke-dasharray=\"6 4\"" : "");
  }

  static void draw_series(Svg& svg, const Series& s, const Frame& frame) {
    std::vector<Vec2> placed;
    placed.reserve(s.points.size());
    for (const Vec2& p : s.points) placed.push_back(frame.at(p));
    if (s.line) svg.polyline(placed, line_style(s));
    const std::string bar = "stroke=\"" + s.colour + "\" stroke-width=\"1.2\"";
    for (std::size_t i = 0; i < placed.size(); ++i) {
      if (y_error(s, i) > 0) {
        const Vec2 error{0, s.y_errors[i]};
        const Vec2 from = frame.at(s.points[i] - error);
        const Vec2 to = frame.at(s.points[i] + error);
        svg.line(from, to, bar);
        for (const Vec2& end : {from, to}) svg.line(end - Vec2{4, 0}, end + Vec2{4, 0}, bar);
      }
      draw_mark(svg, s, placed[i]);
    }
  }

  static void draw_mark(Svg& svg, const Series& s, const Vec2& at) {
    const std::string style = "fill=\"" + s.colour + "\" stroke=\"white\" stroke-width=\"0.6\"";
    if (s.mark == Mark::circle) svg.circle(at, 3.6, style);
    if (s.mark == Mark::square) svg.rectangle(at - Vec2{3.3, 3.3}, {6.6, 6.6}, style);
    if (s.mark == Mark::triangle)
      svg.polygon(std::vector<Vec2>{at + Vec2{0, -4.6}, at + Vec2{4.2, 3.2}, at + Vec2{-4.2, 3.2}},
                  style);
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
