// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Bytes of a fuzzer read as numbers: any doubles, and numbers on which degenerate cases depend.

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace riprap::fuzz {

using Bytes = std::span<const std::uint8_t>;

/// Reads from the front; after the last byte all are 0.
class Input {
 public:
  explicit Input(Bytes bytes) : bytes_(bytes) {}

  [[nodiscard]] bool empty() const { return bytes_.empty(); }

  [[nodiscard]] std::uint8_t byte() {
    if (bytes_.empty()) return 0;
    const std::uint8_t value = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return value;
  }
  /// From 0 to `count` - 1; `count` is at most 256.
  [[nodiscard]] unsigned below(unsigned count) { return byte() % count; }
  [[nodiscard]] bool yes() { return below(2) == 1; }

  /// From 0 to 1, both included.
  [[nodiscard]] double share() {
    const unsigned high = byte();
    return (256 * high + byte()) / 65535.0;
  }
  /// Zero, or of either sign and a magnitude from 2^-58 to 2^-8.
  [[nodiscard]] double tiny() {
    const int exponent = static_cast<int>(below(64));
    if (exponent < 8) return 0;
    const int digits = byte() - 128;
    return std::ldexp(digits < 0 ? digits - 128 : digits + 128, -exponent - 2);
  }
  /// Any double: infinite, NaN and subnormal too.
  [[nodiscard]] double any() {
    std::uint64_t bits = 0;
    for (int i = 0; i < 8; ++i) bits = bits << 8 | byte();
    return std::bit_cast<double>(bits);
  }
  /// A multiple of 1/16 between -8 and 8, such a multiple and a tiny number, or any double.
  [[nodiscard]] double number() {
    const unsigned kind = byte();
    if (kind >= 250) return any();
    const double coarse = (byte() - 128) / 16.0;
    return kind < 160 ? coarse : coarse + tiny();
  }
  /// What is left.
  [[nodiscard]] std::string text() {
    const std::string out(bytes_.begin(), bytes_.end());
    bytes_ = {};
    return out;
  }

 private:
  Bytes bytes_;
};

}  // namespace riprap::fuzz
