// SPDX-License-Identifier: BSL-1.0
#include <riprap/geometry/read_wkt.hpp>

#include <doctest/doctest.h>

#include <string>
#include <string_view>
#include <vector>

#include <support/changed_texts.hpp>
#include <support/message_of.hpp>

using namespace riprap;
using test::contains;
using test::message_of;

namespace {

std::vector<Vec2> vertices(const std::string& text) {
  const ConvexPolygon polygon = read_wkt_polygon(text);
  return {polygon.begin(), polygon.end()};
}
std::string refusal(const std::string& text) {
  return message_of([&] { (void)read_wkt_polygon(text); });
}

const std::vector<Vec2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

}  // namespace

TEST_CASE("a ring is read with its first vertex repeated at the end or not") {
  CHECK(vertices("POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))") == square);
  CHECK(vertices("POLYGON ((0 0, 1 0, 1 1, 0 1))") == square);
}

TEST_CASE("a ring that turns clockwise is turned round") {
  CHECK(vertices("POLYGON ((0 1, 1 1, 1 0, 0 0, 0 1))") == square);
}

TEST_CASE("case and blanks do not count") {
  CHECK(vertices(" \n\tpolygon((0 0,1 0,1 1,0 1))\r\n") == square);
  CHECK(vertices("Polygon  ( ( 0\t0 ,1  0 , 1\n1,0 1 ) ) ") == square);
}

TEST_CASE("numbers are read to the last bit, in any decimal form") {
  CHECK(vertices("POLYGON ((+0 -0.0, 1e0 0., 1.000 .1E1, 0 +10e-1))") == square);
  CHECK(vertices("POLYGON ((-0.1 -1e-3, 0.3333333333333333 0, 0 1))")[1].x() == 1.0 / 3);
}

TEST_CASE("a missing comma is refused with its place") {
  // Boost.Geometry 1.74 reads this as a ring of (0, 0), (1, 1), (0, 1).
  CHECK(refusal("POLYGON((0 0,1 1 0,0 1,0 0))") ==
        "well-known text, character 18: expected ',' or ')' after the two coordinates of a vertex, "
        "found '0'");
  CHECK(refusal("POLYGON((0 0 1 0, 1 1))").starts_with("well-known text, character 14: "));
}

TEST_CASE("third coordinates are refused with their place") {
  CHECK(contains(refusal("POLYGON Z ((0 0 1, 1 0 1, 1 1 1))"), "character 9: expected '((': vert"));
  CHECK(contains(refusal("POLYGON M((0 0 1, 1 0 1, 1 1 1))"), "without Z and M, found 'M'"));
  CHECK(contains(refusal("POLYGON ((0 0 1, 1 0 1, 1 1 1))"), "character 15: expected ',' or ')'"));
}

TEST_CASE("whatever else is not one ring of vertices is refused with its place") {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "character 1: expected POLYGON, found the end of the text"},
      {"  ", "character 3: expected POLYGON, found the end of the text"},
      {"POINT (1 2)", "character 3: expected POLYGON, found 'I'"},
      {"MULTIPOLYGON (((0 0, 1 0, 1 1)))", "character 1: expected POLYGON, found 'M'"},
      {"SRID=4326;POLYGON ((0 0, 1 0, 1 1))", "character 1: expected POLYGON, found 'S'"},
      {"POLYGON", "character 8: expected '(' before the ring, found the end of the text"},
      {"POLYGON EMPTY", "an EMPTY polygon is no particle, found 'E'"},
      {"POLYGON ()", "character 10: expected '((' before the first vertex, found ')'"},
      {"POLYGON (())", "character 11: expected the first coordinate of a vertex, found ')'"},
      {"POLYGON (0 0, 1 0, 1 1)", "character 10: expected '((' before the first vertex, found '0'"},
      {"POLYGON ((0 0, 1 0, 1 1)", "character 25: expected ')' after the ring, found the end"},
      {"POLYGON ((0 0, 1 0, 1 1", "character 24: expected ',' or ')' after the two"},
      {"POLYGON ((0 0, 1 0, 1 1)))", "character 26: expected the end of the text, found ')'"},
      {"POLYGON ((0 0, 1 0, 1 1)) x", "character 27: expected the end of the text, found 'x'"},
      {"POLYGON ((0 0, 1 0, 1 1), (0 0, 1 0, 1 1))", "a particle has no holes, found ','"},
      {"POLYGON ((0 0, 1 0,, 1 1))", "character 20: expected the first coordinate of a vertex"},
      {"POLYGON ((0 0, 1 0, 1 1,))", "character 25: expected the first coordinate of a vertex"},
      {"POLYGON ((0 0, 1, 1 1))", "character 17: expected a blank and the second coordinate"},
      {"POLYGON ((0 0, 1-1, 1 1))", "character 17: expected a blank and the second coordinate"},
      {"POLYGON ((0 0, 1 x, 1 1))", "character 18: expected the second coordinate of a vertex"},
      {"POLYGON ((0 0, 1 +-1, 1 1))", "character 18: expected the second coordinate of a vertex"},
      {"POLYGON ((0 0, 1 0x1p3, 1 1))", "character 19: expected ',' or ')' after the two"},
      {"POLYGON ((0 0, 1 0, 1 nan))", "character 23: expected the second coordinate of a vertex"},
      {"POLYGON ((0 0, -inf 0, 1 1))", "character 16: expected the first coordinate of a vertex"},
      {"POLYGON ((0 0, 1e999 0, 1 1))", "in the range of double precision, 1e-308 to 1e308"},
      {"POLYGON ((0 0, 1e-999 0, 1 1))", "in the range of double precision, 1e-308 to 1e308"},
      {"POLYGON ((0,0 1,0 1,1))", "character 12: expected a blank and the second coordinate"},
  };
  for (const auto& [text, part] : cases) {
    CAPTURE(text);
    CHECK_MESSAGE(contains(refusal(text), part), refusal(text));
  }
}

TEST_CASE("a ring that is no convex polygon is refused as one") {
  CHECK(contains(refusal("POLYGON ((0 0, 1 0))"), "polygon has 2 vertices"));
  CHECK(refusal("POLYGON ((0 0, 4 0, 1 1, 0 4))").starts_with("polygon vertex"));
}

TEST_CASE("any text is read as a polygon or refused, whatever characters it has") {
  using std::string_view_literals::operator""sv;
  const int read =
      test::read_of_changed("POLYGON ((0 0, 1 0, 1 1, 0 1))", "POLYGON ((0 0,1 1.e+-9nan,)\n\0Zx"sv,
                            5, [](const std::string& text) { (void)read_wkt_polygon(text); });
  CHECK(read > 5000);
}
