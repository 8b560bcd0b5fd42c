// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The in-plane stress tensor and its principal values.

#include <algorithm>
#include <cmath>

#include <riprap/core/vec2.hpp>

namespace riprap {

/// Principal stresses [Pa], compression positive, and the unit vector of the major one.
struct PrincipalStress {
  double major = 0;
  double minor = 0;
  Vec2 major_direction{1, 0};
};

/// Principal stresses alone [Pa].
struct PrincipalValues {
  double major = 0;
  double minor = 0;
};

/// Symmetric in-plane stress [Pa], compression positive.
struct Stress2 {
  double s11 = 0;
  double s22 = 0;
  double s12 = 0;

  Stress2& operator+=(const Stress2& o) {
    s11 += o.s11;
    s22 += o.s22;
    s12 += o.s12;
    return *this;
  }
  [[nodiscard]] friend Stress2 operator*(double f, const Stress2& s) {
    return {f * s.s11, f * s.s22, f * s.s12};
  }
  [[nodiscard]] double mean() const { return 0.5 * (s11 + s22); }

  /// Radius of Mohr's circle.
  [[nodiscard]] double radius() const {
    const double half = 0.5 * (s11 - s22);
    return std::sqrt(half * half + s12 * s12);
  }

  /// The larger and the smaller normal stress, moved apart by Jacobi's rotation: mean() - radius()
  /// would cancel where the minor stress is small beside the major one.
  [[nodiscard]] PrincipalValues principal_values() const {
    const double sum = radius() + 0.5 * std::abs(s11 - s22);
    const double shift = sum == 0 ? 0 : s12 * (s12 / sum);
    return {std::max(s11, s22) + shift, std::min(s11, s22) - shift};
  }

  [[nodiscard]] PrincipalStress principal() const {
    const auto [major, minor] = principal_values();
    const double r = radius();
    if (r == 0) return {major, minor, Vec2{1, 0}};
    // Of the two columns of (sigma - minor I) the longer one is the accurate eigenvector.
    const double half = 0.5 * (s11 - s22);
    const Vec2 v = half >= 0 ? Vec2{r + half, s12} : Vec2{s12, r - half};
    return {major, minor, v / std::sqrt(v.dot(v))};
  }

  /// The same stress in axes turned by `r`: components along r * e1 and r * e2 become those along
  /// e1 and e2. Use with a body's rotation to turn body-frame stress into the laboratory frame.
  [[nodiscard]] Stress2 rotated(const Rotation& r) const {
    const double cc = r.cosine * r.cosine;
    const double ss = r.sine * r.sine;
    const double cs = r.cosine * r.sine;
    return {cc * s11 + ss * s22 - 2 * cs * s12, ss * s11 + cc * s22 + 2 * cs * s12,
            cs * (s11 - s22) + (cc - ss) * s12};
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("s11", self.s11);
    visit("s22", self.s22);
    visit("s12", self.s12);
  }
};

/// Symmetric part of the product u v of two vectors: what a force on an arm adds to area times
/// thickness times stress.
[[nodiscard]] inline Stress2 symmetric_product(const Vec2& u, const Vec2& v) {
  return {u.x() * v.x(), u.y() * v.y(), 0.5 * (u.x() * v.y() + u.y() * v.x())};
}

}  // namespace riprap
