#include "compact_svg.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <vector>

namespace report {

namespace {

// Tenths of a pixel: sums of them are exact.
struct Point {
  long x = 0;
  long y = 0;
};

// What is drawn alike.
struct Group {
  bool circles = false;
  std::string style;   // attributes; for what is neither path nor circle, nothing
  std::string colour;  // that of fill and stroke, where it is one alone
  std::string content;
};

std::string tenths(long value) {
  std::string out = value < 0 ? "-" : "";
  value = std::abs(value);
  if (value >= 10 || value == 0) out += std::to_string(value / 10);
  if (value % 10 != 0) out += "." + std::to_string(value % 10);
  return out;
}

// Separated where the next number does not begin with its sign.
void append(std::string& out, long value) {
  const std::string text = tenths(value);
  const bool joined = out.empty() || std::isalpha(static_cast<unsigned char>(out.back()));
  if (!joined && text.front() != '-') out += ' ';
  out += text;
}

std::string attribute(const std::string& element, const std::string& name) {
  const auto at = element.find(" " + name + "=\"");
  if (at == std::string::npos) return "";
  const auto from = at + name.size() + 3;
  return element.substr(from, element.find('"', from) - from);
}

long tenths_of(const std::string& text) {
  return std::lround(10 * std::strtod(text.c_str(), nullptr));
}

std::vector<Point> points_of(const std::string& text) {
  std::vector<Point> points;
  std::istringstream in(text);
  char comma = 0;
  for (double x = 0, y = 0; in >> x >> comma >> y;)
    points.push_back({std::lround(10 * x), std::lround(10 * y)});
  return points;
}

std::string path_of(const std::vector<Point>& points, bool closed) {
  std::string out = "M";
  append(out, points.front().x);
  append(out, points.front().y);
  if (points.size() > 1) out += "l";
  for (std::size_t i = 1; i < points.size(); ++i) {
    append(out, points[i].x - points[i - 1].x);
    append(out, points[i].y - points[i - 1].y);
  }
  return closed ? out + "z" : out;
}

// All attributes behind the last one that tells the shape.
std::string style_behind(const std::string& element, const std::string& name) {
  const auto at = element.find('"', element.find(" " + name + "=\"") + name.size() + 3);
  const auto end = element.rfind("/>");
  const auto first = element.find_first_not_of(' ', at + 1);
  return first < end ? element.substr(first, end - first) : "";
}

std::string colour_of(const std::string& style) {
  const std::string fill = attribute(" " + style, "fill");
  const std::string stroke = attribute(" " + style, "stroke");
  if (stroke.empty() || stroke == "none" || stroke == fill) return fill;
  return fill.empty() || fill == "none" ? stroke : "";
}

Group shape_of(const std::string& line) {
  const bool polygon = line.starts_with("<polygon ");
  if (polygon || line.starts_with("<polyline ")) {
    const auto points = points_of(attribute(line, "points"));
    if (points.empty()) return {false, "", "", ""};
    const std::string style = style_behind(line, "points");
    return {false, style, colour_of(style), path_of(points, polygon)};
  }
  if (line.starts_with("<line ")) {
    const auto at = [&](const char* name) { return tenths_of(attribute(line, name)); };
    const std::string style = style_behind(line, "y2");
    // A line has no area, but a path would fill what it encloses.
    const std::string open = style.find("fill=") == std::string::npos ? "fill=\"none\" " : "";
    return {false, open + style, colour_of(style),
            path_of({{at("x1"), at("y1")}, {at("x2"), at("y2")}}, false)};
  }
  if (line.starts_with("<circle ")) {
    const auto at = [&](const char* name) { return tenths(tenths_of(attribute(line, name))); };
    const std::string style = style_behind(line, "r");
    return {true, style, colour_of(style),
            "<circle cx=\"" + at("cx") + "\" cy=\"" + at("cy") + "\" r=\"" + at("r") + "\"/>\n"};
  }
  return {false, "", "", line + "\n"};
}

// A shape without any style is left as it is.
Group group_of(const std::string& line) {
  const Group shape = shape_of(line);
  return shape.style.empty() ? Group{false, "", "", line + "\n"} : shape;
}

// The group that a shape may join, or none.
Group* place_for(std::vector<Group>& groups, const Group& shape) {
  if (shape.style.empty()) return nullptr;
  constexpr std::size_t furthest = 3;
  for (std::size_t back = 1; back <= std::min(furthest, groups.size()); ++back) {
    Group& group = groups[groups.size() - back];
    if (group.style == shape.style && group.circles == shape.circles) return &group;
    if (shape.colour.empty() || group.colour != shape.colour) return nullptr;
  }
  return nullptr;
}

std::string text_of(const Group& group) {
  if (group.style.empty()) return group.content;
  if (group.circles) return "<g " + group.style + ">\n" + group.content + "</g>\n";
  return "<path d=\"" + group.content + "\" " + group.style + "/>\n";
}

}  // namespace

std::string compact_svg(const std::string& document) {
  std::vector<Group> groups;
  std::istringstream in(document);
  for (std::string line; std::getline(in, line);) {
    const Group shape = group_of(line);
    if (Group* place = place_for(groups, shape))
      place->content += shape.content;
    else
      groups.push_back(shape);
  }
  std::string out;
  for (const Group& group : groups) out += text_of(group);
  return out;
}

}  // namespace report
