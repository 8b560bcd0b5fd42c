// SPDX-License-Identifier: BSL-1.0
#include <riprap/core/simd.hpp>

#include <doctest/doctest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include <riprap/core/random.hpp>

using namespace riprap;

namespace {

std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x); }

template <std::size_t lanes>
void compare_with_scalar() {
  using Several = Simd<double, lanes>;
  static_assert(sizeof(Several) == lanes * sizeof(double));
  Random random(1);
  for (int k = 0; k < 1000; ++k) {
    double a[lanes], b[lanes];
    for (std::size_t l = 0; l < lanes; ++l) {
      a[l] = std::ldexp(random.uniform(-1, 1), static_cast<int>(random.uniform_integer(0, 600)));
      b[l] = random.uniform_integer(0, 4) == 0 ? a[l] : random.uniform(-1, 1);
    }
    const auto va = gather_lanes<Several>([&](std::size_t l) { return a[l]; });
    const auto vb = gather_lanes<Several>([&](std::size_t l) { return b[l]; });
    const Several least = smaller(va, vb);
    const Several most = larger(va, vb);
    const Several root = square_root(Several(va * va));
    const Several quotient = vb / va;
    const Several size = magnitude(va);
    for (std::size_t l = 0; l < lanes; ++l) {
      CHECK(bits(lane(least, l)) == bits(smaller(a[l], b[l])));
      CHECK(bits(lane(most, l)) == bits(larger(a[l], b[l])));
      CHECK(bits(lane(root, l)) == bits(square_root(a[l] * a[l])));
      CHECK(bits(lane(quotient, l)) == bits(b[l] / a[l]));
      CHECK(bits(lane(size, l)) == bits(std::abs(a[l])));
    }
  }
}

}  // namespace

TEST_CASE("every lane computes what a single number would, to the last bit") {
  compare_with_scalar<2>();
  compare_with_scalar<native_lanes>();
}

TEST_CASE("of two numbers the smaller and the larger, the second one where one is not a number") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(smaller(1.0, 2.0) == 1);
  CHECK(larger(1.0, 2.0) == 2);
  CHECK(smaller(nan, 2.0) == 2);
  CHECK(std::isnan(larger(2.0, nan)));
  CHECK(square_root(9.0) == 3);
}

TEST_CASE("the magnitude of four numbers loses their signs alone") {
  const Simd<float, 4> found = magnitude(Simd<float, 4>{-0.0f, 1.5f, -2.5f, -1e-40f});
  CHECK_FALSE(std::signbit(found[0]));
  CHECK(found[1] == 1.5f);
  CHECK(found[2] == 2.5f);
  CHECK(found[3] == 1e-40f);
}

TEST_CASE("square roots of four numbers in single precision are those of each") {
  const Simd<float, 4> found = square_root(Simd<float, 4>{0.0f, 2.0f, 1e-30f, 3e30f});
  for (std::size_t l = 0; l < 4; ++l) {
    const float x = std::array<float, 4>{0.0f, 2.0f, 1e-30f, 3e30f}[l];
    CHECK(found[l] == std::sqrt(x));
  }
}
