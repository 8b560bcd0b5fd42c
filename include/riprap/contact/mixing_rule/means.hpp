// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// One number from the two of two materials; equal numbers give that number to the last bit.

#include <algorithm>
#include <concepts>

#include <riprap/core/compiler.hpp>

namespace riprap {

/// `mean(a, b)` of two numbers, 0 or above.
template <class M>
concept MeanOfTwo = std::copy_constructible<M> && requires(const M& mean, double value) {
  { mean(value, value) } -> std::convertible_to<double>;
};

/// The smaller one: slip begins on the smoother face.
struct Smaller {
  [[nodiscard]] double operator()(double a, double b) const { return std::min(a, b); }
};
/// (a + b) / 2.
struct ArithmeticMean {
  [[nodiscard]] double operator()(double a, double b) const { return 0.5 * (a + b); }
};
/// 2 a b / (a + b): of stiffnesses, each that of a contact of two bodies of one material, the
/// stiffness of two springs 2 a and 2 b in series.
struct InSeries {
  [[nodiscard]] double operator()(double a, double b) const {
    return a + b > 0 ? 2 * (a * (b / (a + b))) : 0;
  }
};

}  // namespace riprap
