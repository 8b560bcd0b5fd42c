// SPDX-License-Identifier: BSL-1.0
#include <riprap/core/conventions.hpp>

#include <cmath>
#include <doctest/doctest.h>
#include <limits>

// The operands are volatile, so that the machine computes and not the compiler.

TEST_CASE("arithmetic is that of IEEE: NaN, infinity and subnormal numbers are what they are") {
  volatile double zero = 0;
  const double nan = zero / zero;
  CHECK(nan != nan);
  CHECK_FALSE(std::isfinite(1 / zero));
  volatile double smallest = std::numeric_limits<double>::min();
  CHECK(smallest / 2 > 0);
}

TEST_CASE("sums are not reordered: a lost term stays lost") {
  volatile double large = 1e16;
  volatile double small = 1;
  CHECK((large + small) - large == 0.0);
}

TEST_CASE("a product and a sum are rounded one after the other") {
  // (1 + e)^2 = 1 + 2e + e^2, and e^2 lies below the last digit; one rounding would keep it.
  volatile double x = 1 + std::numeric_limits<double>::epsilon();
  const double factor = x;
  const double rounded = factor * factor;
  volatile double stored = rounded;
  CHECK(factor * factor - stored == 0.0);
}
