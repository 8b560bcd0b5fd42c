// SPDX-License-Identifier: BSL-1.0
#include <riprap/experiment/check_table.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace riprap;

TEST_CASE(
    "a value is reported the first time that it is beyond its limit, and the worst one kept") {
  CheckTable table;
  const std::size_t row = table.add("load", true, 5, "it breaks");
  CHECK(table.rows()[row].holds());  // never measured
  CHECK(table.measure(row, 5, Stage::hydrostatic, 0).empty());
  CHECK(table.measure(row, 7, Stage::shear, 0.1) ==
        "load = 7 above 5 at strain 0.1 of shear: it breaks");
  CHECK(table.measure(row, 9, Stage::shear, 0.2).empty());
  CHECK(table.measure(row, 6, Stage::shear, 0.3).empty());
  CHECK(table.rows()[row].worst == 9);
  CHECK(table.rows()[row].axial_strain == 0.2);
  CHECK(table.violations() == 1);
}

TEST_CASE("a value below a lower limit is reported") {
  CheckTable table;
  const std::size_t row = table.add("porosity", false, 0, "no room");
  CHECK(table.measure(row, 0, Stage::shear, 0).empty());
  CHECK(table.measure(row, 0.2, Stage::shear, 0.1).empty());
  CHECK(table.rows()[row].worst == 0);
  CHECK(table.measure(row, -0.1, Stage::shear, 0.2) ==
        "porosity = -0.1 below 0 at strain 0.2 of shear: no room");
}

TEST_CASE("a value that is not a number is within no limit, and stays the worst") {
  for (const bool upper : {true, false}) {
    CheckTable table;
    const std::size_t row = table.add("number", upper, 0, "lost");
    CHECK_FALSE(table.measure(row, std::nan(""), Stage::shear, 0).empty());
    CHECK(table.measure(row, upper ? 1 : -1, Stage::shear, 0.1).empty());
    CHECK(std::isnan(table.rows()[row].worst));
    CHECK(table.violations() == 1);
  }
  CheckTable table;
  const std::size_t row = table.add("number", true, 1e300, "too large");
  CHECK_FALSE(table.measure(row, std::numeric_limits<double>::infinity(), Stage::shear, 0).empty());
}
