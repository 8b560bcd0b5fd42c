// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Exact sum of doubles: does not depend on the order of its terms, nor on how they are grouped.

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <riprap/core/compiler.hpp>

namespace riprap {

/// An accumulator of doubles in integers (the small superaccumulator of R. M. Neal 2015, "Fast
/// exact summation using small and large superaccumulators", arXiv:1505.05571): no term is rounded,
/// the value is rounded once, to nearest, ties to even. Sums of parts are joined by `+=`.
///
/// The sum is that of chunks of weight 2^(32 k - 1075). A chunk has 64 bits, so that carries are
/// needed only once in many terms. Any term adds less than 2^32 to one chunk and less than 2^52 to
/// the next.
class ExactSum {
 public:
  ExactSum() = default;

  /// Infinities and NaN add up as doubles do.
  void add(double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    auto exponent = static_cast<std::uint32_t>(bits >> 52) & 0x7ffu;
    std::uint64_t mantissa = bits & ((std::uint64_t{1} << 52) - 1);
    if (exponent - 1 >= 0x7fe) [[unlikely]] {
      if (exponent == 0x7ff) {
        not_finite_ += x;
        return;
      }
      if (mantissa == 0) return;
      exponent = 1;  // subnormal
    } else {
      mantissa |= std::uint64_t{1} << 52;
    }
    const std::uint32_t shift = exponent % 32;
    const auto low = static_cast<std::int64_t>((mantissa << shift) & low_bits);
    const auto high = static_cast<std::int64_t>(mantissa >> (32 - shift));
    const std::int64_t sign = std::bit_cast<std::int64_t>(bits) >> 63;  // 0 or -1
    std::int64_t* const chunk = chunks_.data() + exponent / 32;
    chunk[0] += (low ^ sign) - sign;
    chunk[1] += (high ^ sign) - sign;
    if (++terms_ >= most_terms) carry();
  }

  ExactSum& operator+=(const ExactSum& o) {
    for (std::size_t k = 0; k < size; ++k) chunks_[k] += o.chunks_[k];
    not_finite_ += o.not_finite_;
    terms_ += o.terms_ + 1;  // what a chunk is left with after a carry counts as one term
    if (terms_ >= most_terms) carry();
    return *this;
  }

  /// The sum, rounded to the nearest double; infinite beyond the largest one. A sum of no terms,
  /// and one that cancels, is +0.
  [[nodiscard]] double value() const {
    if (not_finite_ != 0) return not_finite_;
    ExactSum sum = *this;
    sum.carry();
    const bool is_negative = sum.chunks_.back() < 0;
    if (is_negative) {
      for (std::int64_t& chunk : sum.chunks_) chunk = -chunk;
      sum.carry();
    }
    return is_negative ? -sum.magnitude() : sum.magnitude();
  }

  static constexpr bool names_all_members = true;
  static void for_each_field(auto& self, auto&& visit) {
    visit("chunks", self.chunks_);
    visit("not_finite", self.not_finite_);
    visit("terms", self.terms_);
  }

 private:
  static constexpr std::size_t size = 67;
  static constexpr std::uint64_t low_bits = 0xffff'ffff;
  // Two accumulators of so many may be joined without a carry: 2 * 1,000 * 2^52 < 2^63.
  static constexpr std::uint32_t most_terms = 1000;

  // All chunks but the last one, which has the sign of the sum, become those of 32 bits.
  void carry() {
    for (std::size_t k = 0; k + 1 < size; ++k) {
      chunks_[k + 1] += chunks_[k] >> 32;
      chunks_[k] &= static_cast<std::int64_t>(low_bits);
    }
    terms_ = 1;
  }

  [[nodiscard]] std::uint64_t chunk(std::size_t k) const {
    return static_cast<std::uint64_t>(chunks_[k]);
  }

  // Of a sum that is not negative, after a carry.
  [[nodiscard]] double magnitude() const {
    std::size_t top = size - 1;
    while (top > 1 && chunks_[top] == 0) --top;
    // The leading 64 bits begin at the highest one; what is below only says whether it is zero.
    const auto width = static_cast<int>(std::bit_width(chunk(top)));
    if (top == 1 && width <= 22)  // multiples of 2^-1074 below 2^53 of them
      return std::ldexp(static_cast<double>((chunk(1) << 32 | chunk(0)) >> 1), -1074);
    if (width > 32) return std::numeric_limits<double>::infinity();
    const std::uint64_t third = top >= 2 ? chunk(top - 2) : 0;
    const int left = 32 - width;
    const std::uint64_t leading =
        (chunk(top) << 32 | chunk(top - 1)) << left | third >> (32 - left);
    bool is_more = ((third << left) & low_bits) != 0;
    for (std::size_t k = 0; k + 2 < top && !is_more; ++k) is_more = chunks_[k] != 0;
    std::uint64_t mantissa = leading >> 11;
    const std::uint64_t rest = leading & 0x7ff;
    if (rest > 0x400 || (rest == 0x400 && (is_more || mantissa % 2 == 1))) ++mantissa;
    // The lowest bit of `leading` has the weight 2^(32 (top - 1) - 1075 - left).
    return std::ldexp(static_cast<double>(mantissa), 32 * static_cast<int>(top) - 1096 - left);
  }

  std::array<std::int64_t, size> chunks_{};
  double not_finite_ = 0;    // sum of infinities and NaN
  std::uint32_t terms_ = 1;  // since the last carry, at most
};

}  // namespace riprap
