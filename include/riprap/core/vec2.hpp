// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Vectors and rotations of the plane.

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <concepts>
#include <span>
#include <type_traits>

#include <riprap/core/conventions.hpp>
#include <riprap/core/simd.hpp>

namespace riprap {

/// A vector of the plane. Unaligned, so that it packs into records and stays in scalar registers;
/// it mixes freely with Eigen::Vector2d.
using Vec2 = Eigen::Matrix<double, 2, 1, Eigen::DontAlign>;

// Arithmetic at once: Eigen's own operators make classes of every expression, 1,100 functions in a
// program of 25 lines. Templates, so that they are taken for Vec2 itself and nothing else.
template <std::same_as<Vec2> V>
[[nodiscard]] inline Vec2 operator+(const V& a, const V& b) {
  return {a.x() + b.x(), a.y() + b.y()};
}
template <std::same_as<Vec2> V>
[[nodiscard]] inline Vec2 operator-(const V& a, const V& b) {
  return {a.x() - b.x(), a.y() - b.y()};
}
template <std::same_as<Vec2> V>
[[nodiscard]] inline Vec2 operator-(const V& v) {
  return {-v.x(), -v.y()};
}
template <class S, std::same_as<Vec2> V>
  requires std::is_arithmetic_v<S>
[[nodiscard]] inline Vec2 operator*(S s, const V& v) {
  return {s * v.x(), s * v.y()};
}
template <class S, std::same_as<Vec2> V>
  requires std::is_arithmetic_v<S>
[[nodiscard]] inline Vec2 operator*(const V& v, S s) {
  return {v.x() * s, v.y() * s};
}
template <class S, std::same_as<Vec2> V>
  requires std::is_arithmetic_v<S>
[[nodiscard]] inline Vec2 operator/(const V& v, S s) {
  return {v.x() / s, v.y() / s};
}
template <std::same_as<Vec2> V>
inline Vec2& operator+=(V& a, const V& b) {
  a.x() += b.x();
  a.y() += b.y();
  return a;
}
template <std::same_as<Vec2> V>
inline Vec2& operator-=(V& a, const V& b) {
  a.x() -= b.x();
  a.y() -= b.y();
  return a;
}

namespace internal {

/// Both components as one vector.
[[nodiscard, gnu::always_inline]] inline TwoDoubles pair_of(const Vec2& v) {
  return load_lanes<TwoDoubles>(v.data());
}
[[nodiscard, gnu::always_inline]] inline Vec2 vec2_of(const TwoDoubles& pair) {
  Vec2 v;
  store_lanes(v.data(), pair);
  return v;
}

}  // namespace internal

/// Vertices in order, counter-clockwise and open.
using Ring = std::span<const Vec2>;

/// z component of the cross product of a and b.
[[nodiscard]] inline double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Component by component.
[[nodiscard]] inline Vec2 componentwise_product(const Vec2& a, const Vec2& b) {
  return {a.x() * b.x(), a.y() * b.y()};
}
[[nodiscard]] inline Vec2 componentwise_min(const Vec2& a, const Vec2& b) {
  return {std::min(a.x(), b.x()), std::min(a.y(), b.y())};
}
[[nodiscard]] inline Vec2 componentwise_max(const Vec2& a, const Vec2& b) {
  return {std::max(a.x(), b.x()), std::max(a.y(), b.y())};
}
[[nodiscard]] inline Vec2 componentwise_abs(const Vec2& v) {
  return {std::abs(v.x()), std::abs(v.y())};
}

/// Whether neither component is infinite or NaN.
[[nodiscard]] inline bool is_finite(const Vec2& v) {
  return std::isfinite(v.x()) && std::isfinite(v.y());
}

/// v turned by +90 degrees.
[[nodiscard]] inline Vec2 perpendicular(const Vec2& v) { return {-v.y(), v.x()}; }

/// A rotation as a unit complex number: no trigonometry in the hot loop, and the same bits from
/// every compiler.
struct Rotation {
  double cosine = 1;
  double sine = 0;

  [[nodiscard]] static Rotation from_angle(double radians) {
    return {std::cos(radians), std::sin(radians)};
  }
  [[nodiscard]] double angle() const { return std::atan2(sine, cosine); }

  [[nodiscard]] Vec2 operator*(const Vec2& v) const {
    return {cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y()};
  }
  [[nodiscard]] Vec2 inverse_times(const Vec2& v) const {
    return {cosine * v.x() + sine * v.y(), cosine * v.y() - sine * v.x()};
  }

  /// This rotation followed by a small turn [rad]. Cayley's form of the turn is exactly a rotation
  /// and differs from the true angle by turn^3 / 12, below the error of any second-order
  /// integrator.
  [[nodiscard]] Rotation turned(double turn) const {
    const double h = 0.5 * turn;
    const double scale = 1 / (1 + h * h);
    const double c = (1 - h * h) * scale;
    const double s = 2 * h * scale;
    // As pairs: the other way compilers do some of it twice.
    const TwoDoubles now{cosine, sine};
    const TwoDoubles next = now * c + swapped(now) * TwoDoubles{-s, s};
    // One Newton step towards unit length keeps round-off from growing over millions of steps.
    const double unit = 1.5 - 0.5 * (next[0] * next[0] + next[1] * next[1]);
    const TwoDoubles length_one = next * unit;
    return {length_one[0], length_one[1]};
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("cosine", self.cosine);
    visit("sine", self.sine);
  }
};

}  // namespace riprap
