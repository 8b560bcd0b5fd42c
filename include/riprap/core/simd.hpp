// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// SIMD vectors: several numbers in a register, with the operators of a single one.

#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include <riprap/core/compiler.hpp>

#ifdef __AVX__
#include <immintrin.h>
#elif defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace riprap {

namespace internal {
template <class T, std::size_t lanes>
struct SimdVector {
  using type __attribute__((vector_size(lanes * sizeof(T)))) = T;
};
}  // namespace internal

/// So many numbers of type T. The number of lanes is part of the type: no layout depends on the
/// instruction set. Every lane computes what a single number would, to the last bit, so that a
/// formula written for any number type serves for one number and for several.
template <class T, std::size_t lanes>
using Simd = typename internal::SimdVector<T, lanes>::type;

/// Doubles in a vector register of the processor that is compiled for.
#ifdef __AVX__
inline constexpr std::size_t native_lanes = 4;
#else
inline constexpr std::size_t native_lanes = 2;
#endif

using DoubleLanes = Simd<double, native_lanes>;
using TwoDoubles = Simd<double, 2>;

/// From and to memory that need not be aligned.
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

/// (y, x) of (x, y).
[[nodiscard, gnu::always_inline]] inline TwoDoubles swapped(const TwoDoubles& two) {
  return __builtin_shufflevector(two, two, 1, 0);
}

namespace internal {
inline constexpr std::size_t bytes_of_double = sizeof(double);
}  // namespace internal

/// Number of doubles in a number type.
template <class V>
inline constexpr std::size_t lanes_of = sizeof(V) / internal::bytes_of_double;

/// Lane l.
template <class V>
[[nodiscard, gnu::always_inline]] inline double lane(const V& v, std::size_t l) {
  if constexpr (std::same_as<V, double>)
    return v;
  else
    return v[l];
}

/// The numbers `at(0)`, `at(1)`, ... of all lanes.
template <class V, class At>
[[nodiscard, gnu::always_inline]] inline V gather_lanes(At&& at) {
  static_assert(lanes_of<V> == 1 || lanes_of<V> == 2 || lanes_of<V> == 4);
  if constexpr (lanes_of<V> == 1)
    return at(0);
  else if constexpr (lanes_of<V> == 2)
    return V{at(0), at(1)};
  else
    return V{at(0), at(1), at(2), at(3)};
}

/// Smaller and larger of two numbers, lane by lane; the second one where one is not a number.
template <class V>
[[nodiscard, gnu::always_inline]] inline V smaller(const V& a, const V& b) {
  return a < b ? a : b;
}
template <class V>
[[nodiscard, gnu::always_inline]] inline V larger(const V& a, const V& b) {
  return a > b ? a : b;
}

/// Square root, lane by lane.
template <class V>
[[nodiscard, gnu::always_inline]] inline V square_root(const V& x) {
  if constexpr (std::same_as<V, double>) {
    return std::sqrt(x);
  } else {
#ifdef __AVX__
    if constexpr (lanes_of<V> == 4)
      return std::bit_cast<V>(_mm256_sqrt_pd(std::bit_cast<__m256d>(x)));
#endif
#ifdef __SSE2__
    if constexpr (lanes_of<V> == 2) return std::bit_cast<V>(_mm_sqrt_pd(std::bit_cast<__m128d>(x)));
#endif
    return gather_lanes<V>([&](std::size_t l) { return std::sqrt(x[l]); });
  }
}

/// Square roots of four numbers in single precision.
[[nodiscard]] inline Simd<float, 4> square_root(const Simd<float, 4>& x) {
#ifdef __SSE2__
  return std::bit_cast<Simd<float, 4>>(_mm_sqrt_ps(std::bit_cast<__m128>(x)));
#else
  return Simd<float, 4>{std::sqrt(x[0]), std::sqrt(x[1]), std::sqrt(x[2]), std::sqrt(x[3])};
#endif
}

/// Absolute value of doubles, lane by lane.
template <class V>
[[nodiscard, gnu::always_inline]] inline V magnitude(const V& x) {
  if constexpr (std::same_as<V, double>)
    return std::abs(x);
  else
    return std::bit_cast<V>(std::bit_cast<Simd<std::int64_t, lanes_of<V>>>(x) & INT64_MAX);
}

/// Absolute value of four numbers in single precision.
[[nodiscard]] inline Simd<float, 4> magnitude(const Simd<float, 4>& x) {
  return std::bit_cast<Simd<float, 4>>(std::bit_cast<Simd<std::int32_t, 4>>(x) & 0x7FFFFFFF);
}

}  // namespace riprap
