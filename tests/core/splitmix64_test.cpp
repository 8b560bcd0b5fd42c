// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <cmath>
#include <riprap/core/splitmix64.hpp>
#include <set>

using namespace riprap;

TEST_CASE("bits are spread as splitmix64 does it") {
  // First outputs of the published generator for the seeds 0 and 1.
  static_assert(splitmix64(0) == 0xE220A8397B1DCDAFull);
  CHECK(splitmix64(1) == 0x910A2DEC89025CC1ull);
  std::set<std::uint64_t> seen;
  for (std::uint64_t i = 0; i < 10000; ++i) seen.insert(splitmix64(i));
  CHECK(seen.size() == 10000);
}

TEST_CASE("draws are uniform in (0, 1) and belong to their seed and id") {
  CHECK(draw(3, 17) == draw(3, 17));
  CHECK(draw(3, 17) != draw(4, 17));
  constexpr int n = 100000;
  double sum = 0;
  double squares = 0;
  for (std::uint64_t i = 0; i < n; ++i) {
    const double u = draw(1, i);
    REQUIRE(u > 0);
    REQUIRE(u < 1);
    sum += u;
    squares += u * u;
  }
  // Five standard errors of the mean 1/2 and of the second moment 1/3 of n independent draws.
  CHECK(std::abs(sum / n - 0.5) < 5 * std::sqrt(1.0 / 12 / n));
  CHECK(std::abs(squares / n - 1.0 / 3) < 5 * std::sqrt(4.0 / 45 / n));
}
