// SPDX-License-Identifier: BSL-1.0
#include <riprap/core/random.hpp>

#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <limits>
#include <random>

using namespace riprap;

// The C++ standard fixes every number of std::mt19937_64 (and none of its distributions), so the
// engine of the standard library is an independent oracle.

TEST_CASE("uniform numbers are those of the 64-bit Mersenne twister over 2^64, to the last bit") {
  // First output of the engine with its default seed 5489: Nishimura and Matsumoto's
  // mt19937-64.c, and operator() of the standard's engine.
  CHECK(Random(5489).uniform(0, 1) == 14514284786278117030.0 / 18446744073709551616.0);

  for (const std::uint64_t seed : {1ull, 42ull, 0xFFFFFFFFFFFFFFFFull}) {
    Random random(seed);
    std::mt19937_64 engine(seed);
    for (int i = 0; i < 1000; ++i) {
      const double expected = static_cast<double>(engine()) / 18446744073709551616.0;
      CHECK(random.uniform(0, 1) == expected);
    }
  }
}

TEST_CASE("uniform integers are those of the Mersenne twister in equal buckets") {
  Random random(7);
  std::mt19937_64 engine(7);
  // 2^64 - 1 is divisible by three: three buckets of this size and one number left over.
  const std::uint64_t bucket = std::numeric_limits<std::uint64_t>::max() / 3;
  for (int i = 0; i < 1000; ++i)
    CHECK(random.uniform_integer(3, 5) == 3 + static_cast<unsigned>(engine() / bucket));
}

TEST_CASE("the ten-thousandth number is the one the C++ standard prints") {
  Random random(5489);
  for (int i = 1; i < 10000; ++i) (void)random.uniform(0, 1);
  CHECK(random.uniform(0, 1) == 9981545732273789042.0 / 18446744073709551616.0);
}

TEST_CASE("a uniform number fills its half-open range evenly") {
  Random random(11);
  constexpr int n = 100000;
  std::array<int, 10> counts{};
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    const double x = random.uniform(2, 4);
    REQUIRE(x >= 2);
    REQUIRE(x < 4);
    ++counts[static_cast<std::size_t>((x - 2) * 5)];
    sum += x;
  }
  // Five standard deviations of the mean, 2 / sqrt(12 n), and of a count of n / 10.
  CHECK(std::abs(sum / n - 3) < 5 * 2 / std::sqrt(12.0 * n));
  for (const int count : counts) CHECK(std::abs(count - n / 10) < 5 * std::sqrt(0.09 * n));
}

TEST_CASE("an integer reaches both ends of its range, all values alike") {
  Random random(3);
  constexpr int n = 30000;
  std::array<int, 3> counts{};
  for (int i = 0; i < n; ++i) {
    const unsigned k = random.uniform_integer(3, 5);
    REQUIRE(k >= 3);
    REQUIRE(k <= 5);
    ++counts[k - 3];
  }
  // Five standard deviations of a binomial count with p = 1/3.
  for (const int count : counts) CHECK(std::abs(count - n / 3) < 5 * std::sqrt(n * 2.0 / 9));
}

TEST_CASE("an empty range gives its lower end") {
  Random random(3);
  CHECK(random.uniform(0.7, 0.7) == 0.7);
  CHECK(random.uniform(2, 1) == 2);
  CHECK(random.uniform_integer(4, 4) == 4);
}

TEST_CASE("the seed decides the sequence") {
  Random a(1);
  Random b(1);
  Random c(2);
  bool c_differs = false;
  for (int i = 0; i < 100; ++i) {
    const double x = a.uniform(0, 1);
    CHECK(x == b.uniform(0, 1));
    c_differs |= x != c.uniform(0, 1);
  }
  CHECK(c_differs);
}
