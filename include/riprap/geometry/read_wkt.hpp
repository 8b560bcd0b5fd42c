// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Reads a polygon from well-known text (WKT).

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/core/linkage.hpp>
#include <riprap/geometry/convex_polygon.hpp>
#include <riprap/geometry/polygon_properties.hpp>

namespace riprap {

namespace internal {

/// Reads `POLYGON ((x y, x y, ...))` strictly, and says where a text is anything else.
class WktReader {
 public:
  explicit WktReader(std::string_view text) : text_(text) {}

  /// The outer ring as it stands.
  [[nodiscard]] std::vector<Vec2> read_ring() {
    expect_keyword();
    expect('(', "'(' before the ring");
    expect('(', "'((' before the first vertex");
    std::vector<Vec2> ring;
    do ring.push_back(read_vertex());
    while (take(','));
    expect(')', "',' or ')' after the two coordinates of a vertex");
    skip_blanks();
    if (next() == ',') fail("')' after the ring: a particle has no holes");
    expect(')', "')' after the ring");
    skip_blanks();
    if (at_ < text_.size()) fail("the end of the text");
    return ring;
  }

 private:
  [[noreturn]] void fail(const std::string& expected) const {
    std::string found = "the end of the text";
    if (at_ < text_.size()) found = "'" + std::string(text_.substr(at_, 1)) + "'";
    throw InvalidInput("well-known text, character " + std::to_string(at_ + 1) + ": expected " +
                       expected + ", found " + found);
  }
  [[nodiscard]] char next() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  void skip_blanks() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }
  [[nodiscard]] bool take(char c) {
    skip_blanks();
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  void expect(char c, const std::string& what) {
    if (!take(c)) fail(what);
  }

  [[nodiscard]] static char upper(char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  }
  void expect_keyword() {
    skip_blanks();
    for (const char c : std::string_view("POLYGON")) {
      if (upper(next()) != c) fail("POLYGON");
      ++at_;
    }
    skip_blanks();
    if (upper(next()) == 'E') fail("'((' and vertices: an EMPTY polygon is no particle");
    if (upper(next()) == 'Z' || upper(next()) == 'M')
      fail("'((': vertices have two coordinates, without Z and M");
  }

  [[nodiscard]] Vec2 read_vertex() {
    const double x = read_number("the first coordinate of a vertex");
    if (std::string_view(" \t\r\n").find(next()) == std::string_view::npos)
      fail("a blank and the second coordinate of a vertex");
    return {x, read_number("the second coordinate of a vertex")};
  }
  [[nodiscard]] double read_number(const std::string& what) {
    skip_blanks();
    std::size_t first = at_;
    if (next() == '+') ++first;
    // Rules out the names of numbers that are not finite, and a second sign.
    const std::size_t digit = first == at_ && next() == '-' ? first + 1 : first;
    const char c = digit < text_.size() ? text_[digit] : '\0';
    if ((c < '0' || c > '9') && c != '.') fail(what);
    double value = 0;
    const auto read = std::from_chars(text_.data() + first, text_.data() + text_.size(), value);
    if (read.ec == std::errc::result_out_of_range)
      fail(what + " in the range of double precision, 1e-308 to 1e308");
    if (read.ec != std::errc()) fail(what);
    at_ = static_cast<std::size_t>(read.ptr - text_.data());
    return value;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

/// The polygon of a ring that turns either way and may end with its first vertex.
[[nodiscard]] inline ConvexPolygon polygon_of_ring(std::vector<Vec2> ring) {
  if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  if (area_properties(ring).area < 0) std::reverse(ring.begin(), ring.end());
  return ConvexPolygon(std::move(ring));
}

}  // namespace internal

/// The polygon [m] of a text `POLYGON ((x y, x y, ...))`, upper or lower case. Its one ring may
/// turn either way, and may end with its first vertex, as the standard (OGC 06-103r4) has it, or
/// not. Throws InvalidInput for any other text, with the character at which it departs from this
/// form, and for a ring that is no ConvexPolygon.
[[nodiscard]] inline ConvexPolygon read_wkt_polygon(std::string_view text) {
  return internal::polygon_of_ring(internal::WktReader(text).read_ring());
}

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/geometry/read_wkt.ipp>
#endif
