// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/mixing_rule/means.hpp>

#include <doctest/doctest.h>

#include <support/near.hpp>

using namespace riprap;
using test::near_relative;

static_assert(MeanOfTwo<Smaller> && MeanOfTwo<ArithmeticMean> && MeanOfTwo<InSeries>);

TEST_CASE("means of 1 and 3, in any order") {
  CHECK(Smaller{}(1, 3) == 1);
  CHECK(Smaller{}(3, 1) == 1);
  CHECK(ArithmeticMean{}(1, 3) == 2);
  // Springs of 2 and 6 in series: 2 * 6 / 8.
  CHECK(InSeries{}(1, 3) == near_relative(1.5, 1e-15));
  CHECK(InSeries{}(3, 1) == near_relative(1.5, 1e-15));
}

TEST_CASE("a spring in series with none is none") {
  CHECK(InSeries{}(0, 3) == 0);
  CHECK(InSeries{}(0, 0) == 0);
}

TEST_CASE("equal numbers give that number to the last bit") {
  for (const double value : {0.1, 0.577, 2e7, 1.0 / 3, 7e10 / 0.9711}) {
    CHECK(Smaller{}(value, value) == value);
    CHECK(ArithmeticMean{}(value, value) == value);
    CHECK(InSeries{}(value, value) == value);
  }
}
