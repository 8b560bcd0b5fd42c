// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A bilinear form of the axes of two forces, in single precision.

#include <cmath>

#include <riprap/core/simd.hpp>

namespace riprap {

/// Components of an arm and a force, x and y of each; or any four numbers.
using FourFloats = Simd<float, 4>;

[[nodiscard]] inline float lane_sum(const FourFloats& v) { return (v[0] + v[1]) + (v[2] + v[3]); }

struct AxisForm {
  float xx = 0;
  float xy = 0;  ///< of the x of the first force and the y of the second
  float yx = 0;
  float yy = 0;

  /// Of a form that is symmetric and not negative.
  [[nodiscard]] float largest_eigenvalue() const {
    const float half = 0.5f * (xx - yy);
    const float off = 0.5f * (xy + yx);
    return 0.5f * (xx + yy) + std::sqrt(half * half + off * off);
  }
  /// Of the same force (x, y) twice.
  [[nodiscard]] float square(float x, float y) const {
    return x * (x * xx + y * (xy + yx)) + y * y * yy;
  }
};

}  // namespace riprap
