// SPDX-License-Identifier: BSL-1.0
#include <riprap/output/vtp.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

#include <riprap/core/errors.hpp>
#include <support/temporary_file.hpp>
#include <support/vtp_document.hpp>

using namespace riprap;
using riprap::test::read_vtp;

namespace {

const std::vector<Vec2> triangle{{0, 0}, {0.1, 0}, {0, 1.0 / 3}};
const std::vector<Vec2> square{{1, 1}, {2, 1}, {2, 2}, {1, 2}};

VtpFile two_polygons() {
  VtpFile file(VtpCells::polygons);
  file.add_cell(triangle);
  file.add_cell(square);
  return file;
}

}  // namespace

TEST_CASE("cells keep their points, in order and to the last bit") {
  const auto read = read_vtp(two_polygons().document());
  CHECK(read.polygons == 2);
  CHECK(read.lines == 0);
  CHECK(read.cells == std::vector<std::vector<Vec2>>{triangle, square});
}

TEST_CASE("lines are distinguished from polygons") {
  VtpFile file(VtpCells::lines);
  file.add_cell(triangle);
  const auto read = read_vtp(file.document());
  CHECK(read.polygons == 0);
  CHECK(read.lines == 1);
  CHECK(read.cells == std::vector<std::vector<Vec2>>{triangle});
}

TEST_CASE("values belong to cells; whole numbers stay whole, vectors get a third component") {
  VtpFile file = two_polygons();
  const std::vector<double> numbers{1.0 / 3, -2.5e-300};
  const std::vector<Vec2> vectors{{1, 2}, {0.1, -3e20}};
  file.add_values("number", [&](std::size_t k) { return numbers[k]; });
  file.add_values("vector", [&](std::size_t k) { return vectors[k]; });
  file.add_values("count", [](std::size_t k) { return 4000000000u + k; });
  const auto read = read_vtp(file.document());
  REQUIRE(read.arrays.size() == 3);
  CHECK(read.values("number") == numbers);
  CHECK(read.arrays.at("number").type == "Float64");
  CHECK(read.values("vector") == std::vector<double>{1, 2, 0, 0.1, -3e20, 0});
  CHECK(read.arrays.at("vector").components == 3);
  CHECK(read.values("count") == std::vector<double>{4e9, 4e9 + 1});
  CHECK(read.arrays.at("count").type == "Int64");
}

TEST_CASE("the extremes of double read back") {
  using Limits = std::numeric_limits<double>;
  VtpFile file = two_polygons();
  const std::vector<double> numbers{Limits::max(), Limits::min()};
  file.add_values("number", [&](std::size_t k) { return numbers[k]; });
  CHECK(read_vtp(file.document()).values("number") == numbers);
}

TEST_CASE("a file without cells is one") {
  VtpFile file(VtpCells::lines);
  file.add_values("number", [](std::size_t) { return 1.0; });
  const auto read = read_vtp(file.document());
  CHECK(read.cells.empty());
  CHECK(read.values("number").empty());
}

TEST_CASE("what is saved is the document; what cannot be saved says so") {
  const test::TemporaryFile file;
  two_polygons().save(file.path());
  CHECK(file.text() == two_polygons().document());
  CHECK_THROWS_AS(two_polygons().save(file.path() + "/no/such/folder.vtp"), SimulationError);
}

TEST_CASE("cells with points or values that are not finite are left out, and the file says so") {
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    VtpFile file = two_polygons();
    const std::vector<Vec2> lost{{0, 0}, {bad, 0}, {0, 1}};
    file.add_cell(lost);
    file.add_cell(triangle);
    file.add_values("number", [&](std::size_t k) { return k == 0 ? bad : 1.0 * double(k); });
    file.add_values("vector", [&](std::size_t k) { return Vec2{double(k), 0}; });
    file.add_values("count", [](std::size_t k) { return k; });
    const auto read = read_vtp(file.document());
    CHECK(read.cells == std::vector<std::vector<Vec2>>{square, triangle});
    CHECK(read.values("number") == std::vector<double>{1, 3});
    CHECK(read.values("vector") == std::vector<double>{1, 0, 0, 3, 0, 0});
    CHECK(read.values("count") == std::vector<double>{1, 3});
    CHECK(file.document().find("<!-- left out: 2 cells") != std::string::npos);
  }
}
