// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Reads pictures back: a strict reader of the XML that an SVG document is, and where shapes and
/// letters end up.

#include <charconv>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <riprap/core/vec2.hpp>

namespace riprap::test {

/// One element of a picture, in the order of the document.
struct SvgElement {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::string text;

  [[nodiscard]] std::string attribute(const std::string& key) const {
    const auto found = attributes.find(key);
    return found == attributes.end() ? std::string() : found->second;
  }
  /// The whole attribute as one finite number in plain decimals; throws if it is anything else.
  [[nodiscard]] double number(const std::string& key) const { return parsed(attributes.at(key)); }
  [[nodiscard]] Vec2 at(const std::string& x, const std::string& y) const {
    return {number(x), number(y)};
  }
  /// Of a polygon or polyline.
  [[nodiscard]] std::vector<Vec2> points() const {
    std::vector<Vec2> out;
    const std::string& list = attributes.at("points");
    for (std::size_t begin = 0; begin < list.size();) {
      const std::size_t comma = list.find(',', begin);
      const std::size_t end = list.find(' ', begin);
      out.push_back({parsed(list.substr(begin, comma - begin)),
                     parsed(list.substr(comma + 1, end - comma - 1))});
      begin = end == std::string::npos ? list.size() : end + 1;
    }
    return out;
  }

  [[nodiscard]] static double parsed(const std::string& text) {
    double value = 0;
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, value, std::chars_format::fixed);
    if (result.ec != std::errc() || result.ptr != end || !(value - value == 0))
      throw std::runtime_error("not a number: '" + text + "'");
    return value;
  }
};

/// A reader for the part of XML that pictures use: elements, attributes in double quotes, text with
/// the five named entities, comments. Throws std::runtime_error at anything that is not
/// well-formed.
class SvgReader {
 public:
  explicit SvgReader(std::string_view document) : rest_(document) {}

  [[nodiscard]] std::vector<SvgElement> read() {
    do {
      if (rest_.starts_with("<!--"))
        skip_comment();
      else if (rest_.starts_with("</"))
        close();
      else if (rest_.starts_with("<"))
        open();
      else
        read_text();
    } while (!open_.empty());
    while (rest_.starts_with('\n')) rest_.remove_prefix(1);
    if (!rest_.empty()) fail("text after the end");
    return std::move(elements_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error(what + " before: " + std::string(rest_.substr(0, 60)));
  }
  std::string_view take_until(std::string_view stops) {
    const std::size_t end = rest_.find_first_of(stops);
    if (end == std::string_view::npos) fail("no end");
    const std::string_view taken = rest_.substr(0, end);
    rest_.remove_prefix(end);
    return taken;
  }
  void expect(std::string_view token) {
    if (!rest_.starts_with(token)) fail("expected " + std::string(token));
    rest_.remove_prefix(token.size());
  }
  void open() {
    expect("<");
    SvgElement element{std::string(take_until(" />")), {}, {}};
    if (element.name.empty()) fail("no name");
    if (!open_.empty() && elements_[open_.back()].name == "g")
      element.attributes = elements_[open_.back()].attributes;
    while (rest_.starts_with(' ')) {
      rest_.remove_prefix(1);
      const std::string key(take_until("= />"));
      expect("=\"");
      const std::string value = decoded(take_until("\"<"));
      expect("\"");
      if (key.empty() || !element.attributes.emplace(key, value).second) fail("attribute " + key);
    }
    elements_.push_back(std::move(element));
    if (rest_.starts_with("/>")) {
      expect("/>");
    } else {
      expect(">");
      open_.push_back(elements_.size() - 1);
    }
  }
  void close() {
    expect("</");
    if (open_.empty() || take_until(">") != elements_[open_.back()].name) fail("wrong closing");
    expect(">");
    open_.pop_back();
  }
  void skip_comment() {
    const std::size_t end = rest_.find("-->");
    if (end == std::string_view::npos) fail("a comment without end");
    rest_.remove_prefix(end + 3);
  }
  void read_text() {
    if (open_.empty()) fail("text outside");
    elements_[open_.back()].text += decoded(take_until("<"));
  }
  [[nodiscard]] std::string decoded(std::string_view raw) const {
    static const std::map<std::string_view, char> entities{
        {"amp", '&'}, {"lt", '<'}, {"gt", '>'}, {"quot", '"'}, {"apos", '\''}};
    std::string out;
    while (!raw.empty()) {
      if (raw.front() != '&') {
        out += raw.front();
        raw.remove_prefix(1);
        continue;
      }
      const std::size_t end = raw.find(';');
      const auto entity = entities.find(raw.substr(1, end == raw.npos ? 0 : end - 1));
      if (entity == entities.end()) fail("bare ampersand");
      out += entity->second;
      raw.remove_prefix(end + 1);
    }
    return out;
  }

  std::string_view rest_;
  std::vector<SvgElement> elements_;
  std::vector<std::size_t> open_;
};

/// Reads the data of a path of straight lines.
class PathReader {
 public:
  /// Throws std::runtime_error at anything but "M x y L x y" and "M x y l x y x y ... z".
  explicit PathReader(const SvgElement& path) : path_(path), rest_(path.attributes.at("d")) {}

  /// The line (with an absolute end), polyline (open) or polygon (closed) that each part of the
  /// path is, with the attributes that it would have alone.
  [[nodiscard]] std::vector<SvgElement> read() {
    std::vector<SvgElement> out;
    while (!rest_.empty()) {
      if (!take('M')) throw std::runtime_error("no start before: " + std::string(rest_));
      std::vector<Vec2> points{pair()};
      if (take('L')) {
        out.push_back(line(points[0], pair()));
        continue;
      }
      if (take('l'))
        while (!rest_.empty() && rest_.front() != 'M' && rest_.front() != 'z')
          points.push_back(points.back() + pair());
      out.push_back(shape(points, take('z')));
    }
    return out;
  }

 private:
  bool take(char letter) {
    if (rest_.empty() || rest_.front() != letter) return false;
    rest_.remove_prefix(1);
    return true;
  }
  double number() {
    take(' ');
    const std::size_t end = rest_.find_first_of("- MLlz", rest_.starts_with('-') ? 1 : 0);
    std::string text(rest_.substr(0, end));
    rest_.remove_prefix(text.size());
    // Zeros that need not be written.
    const std::size_t first = text.starts_with('-') ? 1 : 0;
    if (first < text.size() && text[first] == '.') text.insert(first, "0");
    return SvgElement::parsed(text);
  }
  Vec2 pair() {
    const double x = number();
    return {x, number()};
  }
  // Decimals of sums come out as they were written.
  [[nodiscard]] static std::string decimal(double value) {
    char buffer[64];
    const auto end =
        std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, 2).ptr;
    return {buffer, end};
  }
  [[nodiscard]] SvgElement element(const std::string& name) const {
    SvgElement out{name, path_.attributes, {}};
    out.attributes.erase("d");
    return out;
  }
  [[nodiscard]] SvgElement line(const Vec2& from, const Vec2& to) const {
    SvgElement out = element("line");
    out.attributes["x1"] = decimal(from.x());
    out.attributes["y1"] = decimal(from.y());
    out.attributes["x2"] = decimal(to.x());
    out.attributes["y2"] = decimal(to.y());
    return out;
  }
  [[nodiscard]] SvgElement shape(const std::vector<Vec2>& points, bool closed) const {
    SvgElement out = element(closed ? "polygon" : "polyline");
    for (const Vec2& p : points)
      out.attributes["points"] += decimal(p.x()) + "," + decimal(p.y()) + " ";
    return out;
  }

  const SvgElement& path_;
  std::string_view rest_;
};

/// All elements in order; paths as the polygons, polylines and lines they consist of, members of
/// groups as if each had the group's attributes.
[[nodiscard]] inline std::vector<SvgElement> svg_elements(const std::string& document) {
  std::vector<SvgElement> out;
  for (const SvgElement& e : SvgReader(document).read()) {
    if (e.name == "g") continue;
    if (e.name != "path") {
      out.push_back(e);
      continue;
    }
    const std::vector<SvgElement> parts = PathReader(e).read();
    out.insert(out.end(), parts.begin(), parts.end());
  }
  return out;
}

[[nodiscard]] inline std::vector<SvgElement> named(const std::vector<SvgElement>& elements,
                                                   const std::string& name) {
  std::vector<SvgElement> out;
  for (const SvgElement& e : elements)
    if (e.name == name) out.push_back(e);
  return out;
}

/// The only text with this content; throws if there is none or more than one.
[[nodiscard]] inline SvgElement text_element(const std::vector<SvgElement>& elements,
                                             const std::string& content) {
  std::vector<SvgElement> found;
  for (const SvgElement& e : named(elements, "text"))
    if (e.text == content) found.push_back(e);
  if (found.size() != 1)
    throw std::runtime_error(std::to_string(found.size()) + " texts '" + content + "'");
  return found.front();
}

/// Width [px] of a text in Helvetica: the advance widths of Adobe's font metrics (1990) for the
/// printable ASCII characters, in thousandths of the font size.
[[nodiscard]] inline double text_width(std::string_view text, double font_size) {
  static constexpr int advance[] = {
      278,  278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333, 278, 278,  // to /
      556,  556, 556, 556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556,  // to ?
      1015, 667, 667, 722, 722, 667, 611, 778, 722, 278, 500, 667, 556, 833, 722, 778,  // to O
      667,  778, 722, 667, 611, 722, 667, 944, 667, 667, 611, 278, 278, 278, 469, 556,  // to _
      333,  556, 556, 500, 556, 556, 278, 556, 556, 222, 222, 500, 222, 833, 556, 556,  // to o
      556,  556, 333, 500, 278, 556, 500, 722, 500, 500, 500, 334, 260, 334, 584};      // to ~
  double sum = 0;
  for (const char c : text) {
    if (c < ' ' || c > '~') throw std::runtime_error("not printable ASCII");
    sum += advance[static_cast<std::size_t>(c - ' ')];
  }
  return 1e-3 * font_size * sum;
}

/// Corners of the rectangle that holds an element.
struct PictureBox {
  Vec2 low{0, 0};
  Vec2 high{0, 0};

  [[nodiscard]] bool holds(const PictureBox& o) const {
    return (o.low.array() >= low.array()).all() && (o.high.array() <= high.array()).all();
  }
};

namespace svg {

[[nodiscard]] inline PictureBox box_of_text(const SvgElement& e) {
  const double size = e.number("font-size");
  const double width = text_width(e.text, size);
  const std::string anchor = e.attribute("text-anchor");
  const double shift = anchor == "middle" ? -0.5 * width : anchor == "end" ? -width : 0;
  const Vec2 at = e.at("x", "y");
  // Ascent 0.72 and descent 0.21 of the font size, from the same metrics.
  if (e.attribute("transform").empty())
    return {at + Vec2{shift, -0.72 * size}, at + Vec2{shift + width, 0.21 * size}};
  // The one turn in use is -90 degrees: the text runs upwards.
  return {at + Vec2{-0.72 * size, -(shift + width)}, at + Vec2{0.21 * size, -shift}};
}

}  // namespace svg

/// Strokes count with their centre line.
[[nodiscard]] inline PictureBox box_of(const SvgElement& e) {
  if (e.name == "text") return svg::box_of_text(e);
  if (e.name == "circle") {
    const Vec2 reach = Vec2::Constant(e.number("r"));
    return {e.at("cx", "cy") - reach, e.at("cx", "cy") + reach};
  }
  if (e.name == "rect") return {e.at("x", "y"), e.at("x", "y") + e.at("width", "height")};
  std::vector<Vec2> points;
  if (e.name == "line")
    points = {e.at("x1", "y1"), e.at("x2", "y2")};
  else
    points = e.points();
  PictureBox box{points.at(0), points.at(0)};
  for (const Vec2& p : points) {
    box.low = box.low.cwiseMin(p);
    box.high = box.high.cwiseMax(p);
  }
  return box;
}

/// The elements that reach beyond the canvas, for the message; empty where all is well. The first
/// two elements are the document itself and its background.
[[nodiscard]] inline std::string outside_canvas(const std::vector<SvgElement>& elements) {
  const PictureBox canvas{{0, 0}, elements.at(0).at("width", "height")};
  std::string out;
  for (std::size_t i = 2; i < elements.size(); ++i) {
    const SvgElement& e = elements[i];
    const bool is_empty = e.attributes.count("points") > 0 && e.points().empty();
    if (!is_empty && !canvas.holds(box_of(e))) out += e.name + " '" + e.text + "'; ";
  }
  return out;
}

}  // namespace riprap::test
