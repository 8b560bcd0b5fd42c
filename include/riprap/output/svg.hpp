#pragma once
/// @file
/// A small writer of scalable vector graphics.

#include <charconv>
#include <string>
#include <string_view>

#include <riprap/core/vec2.hpp>
#include <riprap/output/file.hpp>

namespace riprap {

/// Collects shapes in pixels (y downwards, as SVG has it) and writes them to a file.
class Svg {
 public:
  Svg(double width, double height) : width_(width), height_(height) {}

  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] double height() const { return height_; }

  /// Two decimals: a hundredth of a pixel.
  [[nodiscard]] static std::string number(double value) {
    char buffer[64];
    const auto end =
        std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, 2).ptr;
    return {buffer, end};
  }

  /// @param style SVG attributes such as `fill="none" stroke="#333"`
  template <class Points>
  void polygon(const Points& points, std::string_view style) {
    shape("polygon", points, style);
  }
  template <class Points>
  void polyline(const Points& points, std::string_view style) {
    shape("polyline", points, style);
  }
  void line(const Vec2& from, const Vec2& to, std::string_view style) {
    body_ += "<line x1=\"" + number(from.x()) + "\" y1=\"" + number(from.y()) + "\" x2=\"" +
             number(to.x()) + "\" y2=\"" + number(to.y()) + "\" " + std::string(style) + "/>\n";
  }
  void circle(const Vec2& centre, double radius, std::string_view style) {
    body_ += "<circle cx=\"" + number(centre.x()) + "\" cy=\"" + number(centre.y()) + "\" r=\"" +
             number(radius) + "\" " + std::string(style) + "/>\n";
  }
  void rectangle(const Vec2& corner, const Vec2& size, std::string_view style) {
    body_ += "<rect x=\"" + number(corner.x()) + "\" y=\"" + number(corner.y()) + "\" width=\"" +
             number(size.x()) + "\" height=\"" + number(size.y()) + "\" " + std::string(style) +
             "/>\n";
  }
  /// Text with its anchor (`start`, `middle`, `end`) on the baseline at `at`.
  void text(const Vec2& at, std::string_view content, std::string_view anchor = "start",
            double size = 13, double turn = 0) {
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
           body_ + "</svg>\n";
  }
  /// Throws SimulationError if the file cannot be written.
  void save(const std::string& path) const { write_file(path, document()); }

 private:
  template <class Points>
  void shape(std::string_view element, const Points& points, std::string_view style) {
    body_ += "<" + std::string(element) + " points=\"";
    for (const Vec2& p : points) body_ += number(p.x()) + "," + number(p.y()) + " ";
    body_ += "\" " + std::string(style) + "/>\n";
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
  std::string body_;
};

}  // namespace riprap
