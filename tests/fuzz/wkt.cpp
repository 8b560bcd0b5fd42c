// SPDX-License-Identifier: BSL-1.0
// Any text is a polygon that reads the same when it is written again, or is refused with
// InvalidInput.

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <riprap/geometry/read_wkt.hpp>

#include "check.hpp"
#include "targets.hpp"

namespace riprap::fuzz {

namespace {

std::string ring_text(const std::vector<Vec2>& vertices) {
  std::string text = "POLYGON ((";
  for (std::size_t i = 0; i < vertices.size(); ++i)
    text += (i > 0 ? ", " : "") + to_text(vertices[i].x()) + " " + to_text(vertices[i].y());
  return text + "))";
}

void check_round_trip(const ConvexPolygon& polygon) {
  std::vector<Vec2> vertices(polygon.begin(), polygon.end());
  const auto reads_same = [&polygon](const std::string& text) {
    return std::ranges::equal(read_wkt_polygon(text), polygon);
  };
  check(reads_same(ring_text(vertices)), "a polygon that is written reads the same");
  vertices.push_back(vertices.front());
  check(reads_same(ring_text(vertices)), "a closed ring reads the same");
  std::reverse(vertices.begin(), vertices.end());
  vertices.pop_back();  // reversed again, it begins with the second vertex
  std::rotate(vertices.begin(), vertices.begin() + 1, vertices.end());
  check(reads_same(ring_text(vertices)), "a clockwise ring reads the same");
}

/// A text with a digit, a sign or a letter more is other numbers or none; with a blank more between
/// words it is the same.
void check_blanks(std::string_view text, const ConvexPolygon& polygon) {
  std::string wide;
  for (const char c : text) {
    const bool bracket = std::string_view("(),").find(c) != std::string_view::npos;
    wide += bracket ? std::string(" \t") + c + "\n" : std::string(1, c);
  }
  check(std::ranges::equal(read_wkt_polygon(wide + " "), polygon), "blanks change nothing");
  for (const char* more : {")", "(", ",", "0", "x"}) {
    bool refused = false;
    try {
      (void)read_wkt_polygon(std::string(text) + more);
    } catch (const InvalidInput&) {
      refused = true;
    }
    check(refused, "text after the polygon is refused");
  }
}

}  // namespace

void wkt(Bytes bytes) {
  // The keyword is given, half of the time: the rest is where the cases are.
  Input input(bytes);
  const std::string text = std::string(input.yes() ? "POLYGON ((" : "") + input.text();
  try {
    const ConvexPolygon polygon = read_wkt_polygon(text);
    check_round_trip(polygon);
    check_blanks(text, polygon);
  } catch (const InvalidInput& error) {
    check(std::string_view(error.what()).size() < 300, "a refusal is a sentence");
  }
}

}  // namespace riprap::fuzz
