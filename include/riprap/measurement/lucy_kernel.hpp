// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The smoothing function of Lucy (1977) in the plane.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <riprap/core/errors.hpp>
#include <riprap/core/vec2.hpp>

namespace riprap {

/// phi(r) = 5 / (pi c^2) (1 + 3 r/c) (1 - r/c)^3 up to the radius c, 0 beyond; its integral over
/// the plane is 1, and it has two continuous derivatives. L. B. Lucy, A numerical approach to the
/// testing of the fission hypothesis, Astron. J. 82, 1977, 1013-1024.
struct LucyKernel {
  double radius = 0;  ///< c [m]

  /// Throws InvalidInput unless the radius is above 0.
  void validate() const { require_positive("LucyKernel.radius", radius); }

  /// At a distance from the centre [1/m^2].
  [[nodiscard]] double operator()(double distance) const {
    const double q = distance / radius;
    if (q >= 1) return 0;
    return peak() * (1 + 3 * q) * (1 - q) * (1 - q) * (1 - q);
  }

  /// Mean over the segment from p to q of the kernel about `centre` [1/m^2], in closed form.
  [[nodiscard]] double mean_over(const Vec2& p, const Vec2& q, const Vec2& centre) const {
    const Vec2 branch = q - p;
    const double length = std::sqrt(branch.dot(branch));
    const Vec2 to_p = p - centre;
    if (length == 0) return (*this)(std::sqrt(to_p.dot(to_p)));
    // In units of the radius: along the line from the foot of the perpendicular, h away.
    const double h = cross(to_p, branch) / (length * radius);
    if (std::abs(h) >= 1) return 0;
    const double reach = std::sqrt((1 - h) * (1 + h));
    const double start = to_p.dot(branch) / (length * radius);
    const double end = start + length / radius;
    const double from = std::clamp(start, -reach, reach);
    const double to = std::clamp(end, -reach, reach);
    if (!(from < to)) return 0;
    return peak() * (radius / length) * (integral(to, h * h) - integral(from, h * h));
  }

 private:
  [[nodiscard]] double peak() const { return 5 / (std::numbers::pi * radius * radius); }

  /// Of 1 - 6 q^2 + 8 q^3 - 3 q^4 with q^2 = h^2 + x^2, from 0 to x.
  [[nodiscard]] static double integral(double x, double hh) {
    const double xx = x * x;
    const double q = std::sqrt(hh + xx);
    const double cubes = 0.125 * (x * q * (2 * xx + 5 * hh) +
                                  (hh > 0 ? 3 * hh * hh * std::asinh(x / std::sqrt(hh)) : 0));
    return x * (1 - 6 * (hh + xx / 3) - 3 * (hh * hh + xx * (2 * hh / 3 + xx / 5))) + 8 * cubes;
  }
};

}  // namespace riprap
