// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// SIMD vectors, and how they are read from memory that is aligned to nothing.

#include <cmath>
#include <cstddef>
#include <cstring>

#include <riprap/compiler.hpp>

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

// The names of the instructions: compilers do not find them for a conditional.
[[nodiscard, gnu::always_inline]] inline DoubleLanes least_of(const DoubleLanes& a,
                                                              const DoubleLanes& b) {
#if defined(__AVX__)
  return __builtin_ia32_minpd256(a, b);
#elif defined(__SSE2__)
  return __builtin_ia32_minpd(a, b);
#else
  return a < b ? a : b;
#endif
}
[[nodiscard, gnu::always_inline]] inline DoubleLanes largest_of(const DoubleLanes& a,
                                                                const DoubleLanes& b) {
#if defined(__AVX__)
  return __builtin_ia32_maxpd256(a, b);
#elif defined(__SSE2__)
  return __builtin_ia32_maxpd(a, b);
#else
  return a > b ? a : b;
#endif
}
[[nodiscard, gnu::always_inline]] inline DoubleLanes square_root_of(const DoubleLanes& a) {
#if defined(__AVX__)
  return __builtin_ia32_sqrtpd256(a);
#elif defined(__SSE2__)
  return __builtin_ia32_sqrtpd(a);
#else
  return DoubleLanes{std::sqrt(a[0]), std::sqrt(a[1])};
#endif
}

/// (y, x) of (x, y).
[[nodiscard, gnu::always_inline]] inline TwoDoubles swapped(const TwoDoubles& two) {
  return __builtin_shufflevector(two, two, 1, 0);
}

}  // namespace riprap::internal
