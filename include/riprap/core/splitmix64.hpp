// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Hash of 64-bit numbers, for revisions and for random draws that belong to an id.

#include <cstdint>

#include <riprap/core/compiler.hpp>

namespace riprap {

/// A bijection of the 64-bit numbers whose values look random (splitmix64; Steele, Lea and Flood
/// 2014).
[[nodiscard]] constexpr std::uint64_t splitmix64(std::uint64_t x) {
  std::uint64_t z = x + 0x9E3779B97F4A7C15ull;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
  return z ^ (z >> 31);
}

/// A number in (0, 1) that depends on nothing but `seed` and `id`: the same draw whenever it is
/// asked for.
[[nodiscard]] constexpr double draw(std::uint64_t seed, std::uint64_t id) {
  const std::uint64_t bits = splitmix64(splitmix64(seed) ^ id) >> 11;
  return (static_cast<double>(bits) + 0.5) * 0x1p-53;
}

}  // namespace riprap
