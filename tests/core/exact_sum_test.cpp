// SPDX-License-Identifier: BSL-1.0
#include <riprap/core/exact_sum.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <vector>

#include <riprap/core/fields.hpp>
#include <riprap/core/random.hpp>

using namespace riprap;

namespace {

using Integer = boost::multiprecision::cpp_int;
constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

// In units of half of the smallest number above 0.
Integer exact(double x) {
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);  // of 53 bits
  Integer whole = static_cast<std::int64_t>(std::ldexp(fraction, 53));
  const int shift = exponent - 53 + 1075;
  return shift >= 0 ? Integer(whole << shift) : Integer(whole >> -shift);  // no bit is lost
}

bool is_even(double x) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof x);
  return bits % 2 == 0;
}

// Whether x is the double that is nearest to the sum; of two that are, the even one.
bool is_nearest(double x, const Integer& sum) {
  const Integer miss = sum - exact(x);
  if (miss == 0) return true;
  const double next = std::nextafter(x, miss > 0 ? infinity : -infinity);
  const Integer gap = abs(exact(next) - exact(x));
  const Integer twice = 2 * abs(miss);
  return twice < gap || (twice == gap && is_even(x));
}

double sum_of(const std::vector<double>& terms) {
  ExactSum sum;
  for (const double x : terms) sum.add(x);
  return sum.value();
}

// To the last bit, the sign of zero included.
bool same(double x, double y) { return std::memcmp(&x, &y, sizeof x) == 0; }

}  // namespace

TEST_CASE("sums are the nearest doubles to the sums in integers, for terms of all sizes") {
  Random random(1);
  for (const int spread : {1, 30, 60, 300, 1020})
    for (const int terms : {1, 2, 3, 10, 100, 5000}) {
      CAPTURE(spread);
      CAPTURE(terms);
      std::vector<double> all;
      Integer expected = 0;
      for (int k = 0; k < terms; ++k) {
        const int exponent = static_cast<int>(random.uniform(-spread, spread));
        all.push_back(std::ldexp(random.uniform(-1, 1), exponent));
        expected += exact(all.back());
      }
      CHECK(is_nearest(sum_of(all), expected));
      // With what cancels it but for the last term.
      const double last = all.back();
      for (int k = 0; k + 1 < terms; ++k) all.push_back(-all[static_cast<std::size_t>(k)]);
      CHECK(same(sum_of(all), last));
    }
}

TEST_CASE("halves are rounded to even, whatever is far below decides") {
  const double u = std::ldexp(1, -53);  // half of the last bit of 1
  CHECK(sum_of({1, u}) == 1);
  CHECK(sum_of({1, 2 * u, u}) == 1 + 4 * u);
  for (const double tiny : {smallest, 1e-300, 1e-30}) {
    CHECK(sum_of({1, u, tiny}) == 1 + 2 * u);
    CHECK(sum_of({1, u, -tiny}) == 1);
    CHECK(sum_of({1, 2 * u, u, -tiny}) == 1 + 2 * u);
    CHECK(sum_of({-1, -u, -tiny}) == -1 - 2 * u);
  }
  // Every position of the leading bit in its chunk.
  for (int shift = -1000; shift < 970; ++shift) {
    CHECK(sum_of({std::ldexp(1, shift), std::ldexp(u, shift)}) == std::ldexp(1, shift));
    CHECK(sum_of({std::ldexp(1, shift), std::ldexp(u, shift), smallest}) ==
          std::ldexp(1 + 2 * u, shift));
  }
}

TEST_CASE("subnormal numbers and the largest ones") {
  CHECK(sum_of({smallest}) == smallest);
  CHECK(sum_of({smallest, -2 * smallest}) == -smallest);
  const double normal = std::numeric_limits<double>::min();
  CHECK(sum_of({normal, -smallest}) == normal - smallest);
  CHECK(sum_of({normal, normal, -smallest}) == 2 * normal - smallest);
  CHECK(sum_of({normal, normal, normal, normal, smallest}) == 4 * normal);
  CHECK(sum_of({largest, largest, -largest}) == largest);
  CHECK(sum_of({largest, largest}) == infinity);
  CHECK(sum_of({-largest, -largest}) == -infinity);
  // From half a unit of the last place on the largest number is rounded up.
  const double half = std::ldexp(1, 1023 - 53);
  CHECK(sum_of({largest, half}) == infinity);
  CHECK(sum_of({largest, half, -smallest}) == largest);
  CHECK(sum_of(std::vector<double>(100'000, largest)) == infinity);
  CHECK(same(sum_of({}), 0.0));
  CHECK(same(sum_of({-0.0, -0.0}), 0.0));
  CHECK(same(sum_of({1.5, -1.5}), 0.0));
}

TEST_CASE("infinities and NaN add up as usual") {
  CHECK(sum_of({1, infinity, -largest}) == infinity);
  CHECK(sum_of({-infinity, 1, -infinity}) == -infinity);
  CHECK(std::isnan(sum_of({infinity, 1, -infinity})));
  CHECK(std::isnan(sum_of({not_a_number, 1})));
  CHECK(std::isnan(sum_of({not_a_number, infinity})));
  ExactSum with;
  with.add(infinity);
  ExactSum without;
  without.add(-3);
  without += with;
  CHECK(without.value() == infinity);
}

TEST_CASE("neither the order of the terms nor their grouping changes a bit") {
  Random random(2);
  std::vector<double> terms;
  for (int k = 0; k < 3000; ++k)
    terms.push_back(std::ldexp(random.uniform(-1, 1), static_cast<int>(random.uniform(-80, 80))));
  const double expected = sum_of(terms);
  for (int round = 0; round < 30; ++round) {
    for (std::size_t k = terms.size(); k-- > 1;)
      std::swap(terms[k], terms[random.uniform_integer(0, static_cast<unsigned>(k))]);
    CHECK(same(sum_of(terms), expected));
    // Parts, joined to each other at random until one is left.
    std::vector<ExactSum> parts(1 + random.uniform_integer(0, 60));
    for (const double x : terms)
      parts[random.uniform_integer(0, static_cast<unsigned>(parts.size() - 1))].add(x);
    while (parts.size() > 1) {
      const ExactSum last = parts.back();
      parts.pop_back();
      parts[random.uniform_integer(0, static_cast<unsigned>(parts.size() - 1))] += last;
    }
    CHECK(same(parts.front().value(), expected));
  }
}

TEST_CASE("millions of equal terms, one by one and doubled by joining, need no other treatment") {
  for (const double term : {-largest / 1e7, 0.1, -std::ldexp(1 - 0x1p-53, 31)}) {
    ExactSum sum;
    for (int k = 0; k < 3'000'000; ++k) sum.add(term);
    CHECK(is_nearest(sum.value(), 3'000'000 * exact(term)));
    ExactSum doubled;
    doubled.add(1e-9 * term);
    for (int k = 0; k < 20; ++k) doubled += ExactSum(doubled);
    CHECK(doubled.value() == std::ldexp(1e-9 * term, 20));
  }
}

TEST_CASE("a sum has three fields") {
  ExactSum one;
  int fields = 0;
  riprap::for_each_field(one, [&](const char*, auto&) { ++fields; });
  CHECK(fields == 3);
}
