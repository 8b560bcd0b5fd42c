// SPDX-License-Identifier: BSL-1.0
#include <riprap/geometry/read_outlines.hpp>

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include <riprap/core/units.hpp>
#include <riprap/geometry/polygon_properties.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>
#include <support/temporary_folder.hpp>

using namespace riprap;
using namespace riprap::test;

TEST_CASE("concave outlines are read in a stated unit") {
  const TemporaryFolder folder;
  const std::filesystem::path wkt = std::filesystem::path(folder.path()) / "stones.wkt";
  std::ofstream(wkt) << "# an L, clockwise, and a square\n"
                        "POLYGON ((0 0, 0 20, 10 20, 10 10, 20 10, 20 0, 0 0))\n"
                        "POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0))\n";
  const auto outlines = read_outlines(wkt, 1_mm);
  REQUIRE(outlines.size() == 2);
  CHECK(outlines[0].ring().size() == 6);
  CHECK(polygon_area(outlines[0].ring()) == near_relative(300e-6, 1e-14));
  CHECK(polygon_area(read_outlines(wkt, 1)[1].ring()) == 100);
  const std::filesystem::path csv = std::filesystem::path(folder.path()) / "stones.csv";
  std::ofstream(csv) << "id,x,y\na,0,0\na,4,0\na,1,1\na,0,4\n";
  CHECK(polygon_area(read_outlines(csv, 1_mm).front().ring()) == near_relative(4e-6, 1e-14));
}

TEST_CASE("what is no outline is refused with the file and the lines") {
  const TemporaryFolder folder;
  const std::string wkt = (std::filesystem::path(folder.path()) / "stones.wkt").string();
  std::ofstream(wkt) << "POLYGON ((0 0, 1 0, 1 1))\nPOLYGON ((0 0, 1 1, 1 0, 0 1))\n";
  const std::string crossed = message_of([&] { (void)read_outlines(wkt, 1); });
  CHECK(contains(crossed, wkt + ", line 2: outline edge from (0, 0) to (1, 1) meets the edge"));
  std::ofstream(wkt) << "POLYGON ((0 0, 9 0, 9 9, 0 9), (1 1, 2 1, 2 2))\n";
  CHECK(contains(message_of([&] { (void)read_outlines(wkt, 1); }), "a particle has no holes"));
  std::ofstream(wkt) << "# none\n";
  CHECK(contains(message_of([&] { (void)read_outlines(wkt, 1); }), "must have one or more"));
  const std::string csv = (std::filesystem::path(folder.path()) / "stones.csv").string();
  std::ofstream(csv) << "id,x,y\na,0,0\na,1,0\n";
  CHECK(contains(message_of([&] { (void)read_outlines(csv, 1); }),
                 csv + ", lines 2 to 3, id 'a': outline has 2 vertices"));
  CHECK(contains(message_of([&] { (void)read_outlines(csv, 0); }), "unit = 0"));
  CHECK(contains(message_of([] { (void)read_outlines("stones.txt", 1); }),
                 "must end in .wkt or .csv"));
}
