// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A small writer of scalable vector graphics.

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/core/vec2.hpp>
#include <riprap/output/file.hpp>

namespace riprap {

/// Collects shapes in pixels (y downwards, as SVG has it) and writes them to a file. Polygons and
/// lines of one style that follow each other become one path, circles one group: pictures of many
/// shapes stay small.
///
/// What has a coordinate or a size that is not finite or beyond a billion pixels, or a negative
/// size, is left out, and a line at the bottom of the picture gives the number of parts left out.
class Svg {
 public:
  /// @param decimals of the corners of polygons and lines, and of circles
  /// @throws InvalidInput unless width and height are finite numbers, 0 or above
  Svg(double width, double height, int decimals = 2)
      : width_(width), height_(height), decimals_(decimals) {
    require_non_negative("width of a picture", width);
    require_non_negative("height of a picture", height);
  }

  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] double height() const { return height_; }
  /// Parts that were left out.
  [[nodiscard]] std::size_t left_out() const { return left_out_; }
  /// Counts a part that the caller cannot draw.
  void leave_out() { ++left_out_; }

  /// Two decimals: a hundredth of a pixel.
  [[nodiscard]] static std::string number(double value) {
    char buffer[400];  // holds the largest double
    const auto end =
        std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, 2).ptr;
    return {buffer, end};
  }

  /// @param style SVG attributes such as `fill="none" stroke="#333"`
  template <class Points>
  void polygon(const Points& points, std::string_view style) {
    for (const Vec2& p : points)
      if (!can_draw(p)) return leave_out();
    if (shape(points, style)) run_ += 'z';
  }
  /// A point that cannot be drawn leaves a gap.
  template <class Points>
  void polyline(const Points& points, std::string_view style) {
    std::vector<Vec2> piece;
    for (const Vec2& p : points) {
      if (can_draw(p)) {
        piece.push_back(p);
        continue;
      }
      leave_out();
      shape(piece, style);
      piece.clear();
    }
    shape(piece, style);
  }
  void line(const Vec2& from, const Vec2& to, std::string_view style) {
    if (!can_draw(from) || !can_draw(to)) return leave_out();
    continue_run(Run::path, style);
    run_ += "M" + pair_text(units(from.x()), units(from.y())) + "L" +
            pair_text(units(to.x()), units(to.y()));
  }
  void circle(const Vec2& centre, double radius, std::string_view style) {
    if (!can_draw(centre) || !is_size(radius)) return leave_out();
    continue_run(Run::circles, style);
    run_ += "<circle cx=\"" + short_text(units(centre.x())) + "\" cy=\"" +
            short_text(units(centre.y())) + "\" r=\"" + number(radius) + "\"/>";
  }
  void rectangle(const Vec2& corner, const Vec2& size, std::string_view style) {
    if (!can_draw(corner) || !is_size(size.x()) || !is_size(size.y())) return leave_out();
    end_run();
    body_ += "<rect x=\"" + number(corner.x()) + "\" y=\"" + number(corner.y()) + "\" width=\"" +
             number(size.x()) + "\" height=\"" + number(size.y()) + "\" " + std::string(style) +
             "/>\n";
  }
  /// Text with its anchor (`start`, `middle`, `end`) on the baseline at `at`.
  void text(const Vec2& at, std::string_view content, std::string_view anchor = "start",
            double size = 13, double turn = 0) {
    if (!can_draw(at) || !is_size(size) || !can_draw(turn)) return leave_out();
    end_run();
    body_ += "<text x=\"" + number(at.x()) + "\" y=\"" + number(at.y()) + "\" font-size=\"" +
             number(size) + "\" text-anchor=\"" + std::string(anchor) + "\"";
    if (turn != 0)
      body_ += " transform=\"rotate(" + number(turn) + " " + number(at.x()) + " " + number(at.y()) +
               ")\"";
    body_ += ">" + escaped(content) + "</text>\n";
  }

  [[nodiscard]] std::string document() const {
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + number(width_) + " " +
           number(height_) + "\" width=\"" + number(width_) + "\" height=\"" + number(height_) +
           "\" font-family=\"Helvetica, Arial, sans-serif\" fill=\"#222\">\n"
           "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n" +
           body_ + run_text() + note() + "</svg>\n";
  }
  /// Throws SimulationError if the file cannot be written.
  void save(const std::string& path) const { write_file(path, document()); }

 private:
  static constexpr double largest = 1e9;  // pixels

  [[nodiscard]] static bool can_draw(double value) { return std::abs(value) <= largest; }
  [[nodiscard]] static bool can_draw(const Vec2& p) { return can_draw(p.x()) && can_draw(p.y()); }
  [[nodiscard]] static bool is_size(double value) { return value >= 0 && value <= largest; }

  [[nodiscard]] std::string note() const {
    if (left_out_ == 0) return {};
    return "<text x=\"8\" y=\"" + number(height_ - 6) +
           "\" font-size=\"12\" fill=\"#c0392b\">not drawn: " + std::to_string(left_out_) +
           " parts whose numbers are not finite or too large</text>\n";
  }

  /// What the shapes added last have in common.
  enum class Run { none, path, circles };

  void continue_run(Run kind, std::string_view style) {
    if (kind == run_kind_ && style == run_style_) return;
    end_run();
    run_kind_ = kind;
    run_style_ = style;
  }
  void end_run() {
    body_ += run_text();
    run_kind_ = Run::none;
    run_.clear();
  }
  [[nodiscard]] std::string run_text() const {
    switch (run_kind_) {
    case Run::path:
      return "<path " + run_style_ + " d=\"" + run_ + "\"/>\n";
    case Run::circles:
      return "<g " + run_style_ + ">" + run_ + "</g>\n";
    case Run::none:
      break;
    }
    return {};
  }

  // The first corner is absolute, the others are relative to the one before; rounded first, so that
  // nothing adds up. False if there is none.
  template <class Points>
  bool shape(const Points& points, std::string_view style) {
    continue_run(Run::path, style);
    std::size_t corner = 0;
    std::int64_t x = 0;
    std::int64_t y = 0;
    for (const Vec2& p : points) {
      const std::string step = pair_text(units(p.x()) - x, units(p.y()) - y);
      if (corner < 2)
        run_ += corner == 0 ? 'M' : 'l';
      else if (step.front() != '-')
        run_ += ' ';
      run_ += step;
      ++corner;
      x = units(p.x());
      y = units(p.y());
    }
    return corner > 0;
  }

  // A sign separates numbers as well as a space does.
  [[nodiscard]] std::string pair_text(std::int64_t x, std::int64_t y) const {
    return short_text(x) + (y < 0 ? "" : " ") + short_text(y);
  }
  // In units of the last decimal.
  [[nodiscard]] std::int64_t units(double value) const {
    return std::llround(value * std::pow(10, decimals_));
  }
  // Without zeros that say nothing: 12.5, .5, -3
  [[nodiscard]] std::string short_text(std::int64_t units) const {
    if (units == 0) return "0";
    std::string digits = std::to_string(std::abs(units));
    const auto decimals = static_cast<std::size_t>(decimals_);
    if (digits.size() < decimals) digits.insert(0, decimals - digits.size(), '0');
    std::string fraction = digits.substr(digits.size() - decimals);
    fraction.erase(fraction.find_last_not_of('0') + 1);
    digits.resize(digits.size() - decimals);
    return (units < 0 ? "-" : "") + digits + (fraction.empty() ? "" : "." + fraction);
  }

  [[nodiscard]] static std::string escaped(std::string_view content) {
    std::string out;
    for (const char c : content) {
      if (c == '&')
        out += "&amp;";
      else if (c == '<')
        out += "&lt;";
      else
        out += c;
    }
    return out;
  }

  double width_;
  double height_;
  int decimals_;
  std::string body_;
  Run run_kind_ = Run::none;
  std::string run_style_;
  std::string run_;  // not yet in body_
  std::size_t left_out_ = 0;
};

}  // namespace riprap
