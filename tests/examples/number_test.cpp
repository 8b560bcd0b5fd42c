// SPDX-License-Identifier: BSL-1.0
#include <command_line/number.hpp>

#include <doctest/doctest.h>

#include <cstdint>
#include <limits>
#include <string>

using command_line::number_from;
using command_line::text_of;

TEST_CASE("whole numbers do not wrap round, have one base and no other characters") {
  CHECK(number_from<std::uint64_t>("0") == 0);
  CHECK(number_from<std::uint64_t>("18446744073709551615") == 18446744073709551615U);
  CHECK(number_from<unsigned>("+007") == 7U);
  for (const std::string text : {"-1", "-0", "-18446744073709551615", "18446744073709551616", "",
                                 " 1", "1 ", "1.0", "1e3", "0x10", "+-1", "++1", "one", "1,000"}) {
    CAPTURE(text);
    CHECK(!number_from<std::uint64_t>(text));
    CHECK(!number_from<unsigned>(text));
  }
  CHECK(!number_from<unsigned>("4294967296"));
}

TEST_CASE("numbers are finite decimals") {
  CHECK(number_from<double>("8e6") == 8e6);
  CHECK(number_from<double>("-.5") == -0.5);
  CHECK(number_from<double>("+2.") == 2.0);
  for (const std::string text : {"", "nan", "inf", "-inf", "1e400", "0x1p3", "1,5", "1 ", " 1",
                                 "1e", "--1", "+-1", "8MPa"}) {
    CAPTURE(text);
    CHECK(!number_from<double>(text));
  }
}

TEST_CASE("the text of a number reads back as the same number") {
  using Limits = std::numeric_limits<double>;
  for (const double value :
       {0.0, 0.1, 1.0 / 3, 2e6, -1e-300, Limits::max(), Limits::min(), 0.1 + 0.2})
    CHECK(number_from<double>(text_of(value)) == value);
  const std::uint64_t seed = 18446744073709551615U;
  CHECK(number_from<std::uint64_t>(text_of(seed)) == seed);
}
