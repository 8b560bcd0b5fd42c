// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// SIMD vectors, and how they are read from memory that is aligned to nothing.

#include <cstddef>
#include <cstring>

namespace riprap::internal {

/// As many as a register has.
#ifdef __AVX__
using DoubleLanes = double __attribute__((vector_size(32)));
#else
using DoubleLanes = double __attribute__((vector_size(16)));
#endif
inline constexpr std::size_t double_lanes = sizeof(DoubleLanes) / sizeof(double);

using TwoDoubles = double __attribute__((vector_size(16)));

template <class V, class T>
[[nodiscard, gnu::always_inline]] inline V load_lanes(const T* from) {
  V lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}
template <class V, class T>
[[gnu::always_inline]] inline void store_lanes(T* to, const V& lanes) {
  std::memcpy(to, &lanes, sizeof lanes);
}

}  // namespace riprap::internal
