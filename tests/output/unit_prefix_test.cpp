// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>

#include <riprap/output/unit_prefix.hpp>
#include <support/extreme_numbers.hpp>
#include <support/near.hpp>

using namespace riprap;
using riprap::test::near_relative;

TEST_CASE("the prefix leaves one to three digits before the point") {
  for (double value = 1e-9; value < 1e12; value *= 1.013) {
    CAPTURE(value);
    const double digits = value / unit_prefix(value).factor;
    CHECK(digits >= 1 - 1e-9);
    CHECK(digits < 1000);
  }
}

TEST_CASE("prefixes are those of the SI") {
  const auto symbol = [](double value) { return std::string(unit_prefix(value).symbol); };
  CHECK(symbol(2e-9) == "n");
  CHECK(symbol(2e-6) == "u");
  CHECK(symbol(2e-3) == "m");
  CHECK(symbol(2) == "");
  CHECK(symbol(2e3) == "k");
  CHECK(symbol(2e6) == "M");
  CHECK(symbol(2e9) == "G");
  CHECK(unit_prefix(2e-3).factor == 1e-3);
}

TEST_CASE("what is beyond all prefixes has the last one, and zero none") {
  CHECK(unit_prefix(1e15).factor == 1e9);
  CHECK(unit_prefix(1e-15).factor == 1e-9);
  CHECK(unit_prefix(0).factor == 1);
}

TEST_CASE("a power of ten that was computed a digit too small still counts as one") {
  for (int power = -9; power <= 9; power += 3)
    CHECK(unit_prefix(std::nextafter(std::pow(10, power), 0.0)).factor ==
          near_relative(std::pow(10, power), 1e-12));
}

TEST_CASE("three digits count, whatever the size, and no exponent is needed") {
  CHECK(rounded_text(0) == "0");
  CHECK(rounded_text(3 * 0.1) == "0.3");
  CHECK(rounded_text(0.012345) == "0.0123");
  CHECK(rounded_text(999.6) == "1000");
  CHECK(rounded_text(1400) == "1400");
  CHECK(rounded_text(1234567) == "1230000");
  CHECK(rounded_text(-12.54) == "-12.5");
  CHECK(rounded_text(1e21) == "1000000000000000000000");
}

TEST_CASE("any finite number has a text of plain decimals") {
  for (const double value :
       {std::numeric_limits<double>::max(), -std::numeric_limits<double>::max(),
        std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::min()}) {
    CAPTURE(value);
    // Three digits of the largest double, 1.80e308, are beyond it: they stay what they were.
    CHECK(rounded_text(value).find_first_not_of("-.0123456789") == std::string::npos);
    CHECK(!rounded_text(value).empty());
  }
}

TEST_CASE("any number has a prefix and a text") {
  for (const double value : test::extreme_numbers) {
    CHECK(unit_prefix(value).factor > 0);
    CHECK(!rounded_text(value).empty());
  }
  CHECK(rounded_text(std::nan("")) == "nan");
}
