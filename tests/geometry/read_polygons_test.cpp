// SPDX-License-Identifier: BSL-1.0
#include <riprap/geometry/read_polygons.hpp>

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <support/changed_texts.hpp>
#include <support/message_of.hpp>

using namespace riprap;
using test::contains;
using test::message_of;

namespace {

std::vector<ConvexPolygon> from_wkt(const std::string& text) {
  std::istringstream in(text);
  return read_wkt_polygons(in, "p.wkt");
}
std::vector<ConvexPolygon> from_csv(const std::string& rows) {
  std::istringstream in("id,x,y\n" + rows);
  return read_csv_polygons(in, "p.csv");
}
std::string wkt_refusal(const std::string& text) {
  return message_of([&] { (void)from_wkt(text); });
}
std::string csv_refusal(const std::string& rows) {
  return message_of([&] { (void)from_csv(rows); });
}
std::vector<Vec2> vertices(const ConvexPolygon& polygon) {
  return {polygon.begin(), polygon.end()};
}

const std::vector<Vec2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
const std::vector<Vec2> triangle{{2, 0}, {3, 0}, {2, 4}};

}  // namespace

TEST_CASE("a line of well-known text is a polygon") {
  const auto polygons = from_wkt("# two\nPOLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))\n\n"
                                 "polygon((2 4,3 0,2 0))\r\n");
  REQUIRE(polygons.size() == 2);
  CHECK(vertices(polygons[0]) == square);
  CHECK(vertices(polygons[1]) == triangle);  // turned round
}

TEST_CASE("rows of one id are a polygon, closed or not, either way round") {
  const auto polygons = from_csv("a,0,0\na,1,0\na,1,1\na,0,1\na,0,0\n7,2,4\n7,3,0\n7,2,0\n");
  REQUIRE(polygons.size() == 2);
  CHECK(vertices(polygons[0]) == square);
  CHECK(vertices(polygons[1]) == triangle);
}

TEST_CASE("a text without polygons is refused") {
  CHECK(wkt_refusal("\n# none\n") == "p.wkt: no polygons: must have one or more");
  CHECK(csv_refusal("") == "p.csv: no polygons: must have one or more");
}

TEST_CASE("a line that is no polygon is refused with its number and the character") {
  CHECK(wkt_refusal("POLYGON ((0 0, 1 0, 1 1))\nPOLYGON ((0 0 1, 1 0, 1 1))\n") ==
        "p.wkt, line 2: well-known text, character 15: expected ',' or ')' after the two "
        "coordinates of a vertex, found '1'");
  CHECK(wkt_refusal("POLYGON ((0 0, 1 0, 1 1)) POLYGON ((0 0, 1 0, 1 1))\n") ==
        "p.wkt, line 1: well-known text, character 27: expected the end of the text, found 'P'");
}

TEST_CASE("a polygon that breaks a rule is refused with its line and vertex") {
  CHECK(wkt_refusal("\nPOLYGON ((0 0, 4 0, 1 1, 0 4))\n") ==
        "p.wkt, line 2: polygon vertex 3 at (0, 4) lies -2.5298221281347035 m to the left of the "
        "edge from vertex 1 at (4, 0): must be above 5.656854249492381e-09 m (strictly convex, "
        "counter-clockwise)");
  CHECK(contains(wkt_refusal("POLYGON ((0 0, 1 0))"), "p.wkt, line 1: polygon has 2 vertices"));
}

TEST_CASE("a polygon of rows that breaks a rule is refused with its lines, id and vertex") {
  const std::string good = "a,0,0\na,1,0\na,1,1\n";
  // Not convex.
  CHECK(contains(csv_refusal(good + "b,0,0\nb,4,0\nb,1,1\nb,0,4\n"),
                 "p.csv, lines 5 to 8, id 'b': polygon vertex 3 at (0, 4) lies -2.5"));
  // Self-crossing: a bow tie, and a star, all corners of which turn left.
  CHECK(contains(csv_refusal("bow,0,0\nbow,1,1\nbow,1,0\nbow,0,1\n"),
                 "p.csv, lines 2 to 5, id 'bow': polygon vertex"));
  CHECK(contains(csv_refusal("s,0,3\ns,-2,-3\ns,3,1\ns,-3,1\ns,2,-3\n" + good),
                 "p.csv, lines 2 to 6, id 's': polygon vertex"));
  CHECK(csv_refusal("b,0,0\nb,4,0\n" + good) ==
        "p.csv, lines 2 to 3, id 'b': polygon has 2 vertices: must be 3 to 64");
  CHECK(contains(csv_refusal("b,0,0\nb,1,0\nb,1,0\nb,0,1\n"), "vertices must be distinct"));
  CHECK(contains(csv_refusal("b,0,0\nb,1,0\nb,2,0\n"), "strictly convex"));
}

TEST_CASE("a cell that breaks a rule is refused with its line") {
  CHECK(csv_refusal("a,0,0\na,1,O\n") == "p.csv, line 3: y = 'O': must be a finite number");
  CHECK(csv_refusal("a,0\n") == "p.csv, line 2: 2 cells: must be 3, id,x,y");
  CHECK(csv_refusal(",0,0\n") == "p.csv, line 2: id = '': must not be empty");
  CHECK(csv_refusal("a,0,0\na,1,0\na,1,1\nb,5,0\nb,6,0\nb,6,1\na,0,1\n") ==
        "p.csv, line 8: id = 'a': its vertices must stand in consecutive rows");
  std::istringstream in("x,y\n0,0\n");
  CHECK(message_of([&] { (void)read_csv_polygons(in, "p.csv"); }) ==
        "p.csv, line 1: header 'x,y': must be id,x,y");
}

TEST_CASE("files are read by the end of their names") {
  const auto folder = std::filesystem::temp_directory_path();
  const auto path = folder / ("riprap_read_polygons_" + std::to_string(std::random_device{}()));
  const std::string wkt = path.string() + ".wkt";
  const std::string csv = path.string() + ".csv";
  std::ofstream(wkt) << "POLYGON ((0 0, 1 0, 1 1, 0 1))\n";
  std::ofstream(csv) << "id,x,y\n1,2,0\n1,3,0\n1,2,4\n";
  CHECK(vertices(read_polygons(wkt).front()) == square);
  CHECK(vertices(read_polygons(csv).front()) == triangle);
  std::ofstream(csv) << "id,x,y\n1,2,0\n";
  CHECK(message_of([&] { (void)read_polygons(csv); }).starts_with(csv + ", lines 2 to 2, id '1'"));
  std::filesystem::remove(wkt);
  std::filesystem::remove(csv);
  CHECK(message_of([&] { (void)read_polygons(wkt); }) ==
        "cannot read " + wkt + ": No such file or directory");
  CHECK(message_of([] { (void)read_polygons("rocks.txt"); }) ==
        "file of polygons 'rocks.txt': must end in .wkt or .csv");
}

TEST_CASE("any text is read as polygons or refused, whatever characters it has") {
  using std::string_view_literals::operator""sv;
  const int read = test::read_of_changed("a,0,0\na,1,0\na,1,1\nb,2,0\nb,3,0\nb,2,4\n",
                                         "id,xy\n\r01.e+-9nab#\"\0\xEF"sv, 6,
                                         [](const std::string& text) { (void)from_csv(text); });
  CHECK(read > 5000);
}
