// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The grading curve: which share of a sample's mass is finer than a size.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/core/linkage.hpp>
#include <riprap/geometry/polygon_properties.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// Grains of one size.
struct SizeFraction {
  double size = 0;  ///< [m]
  double mass = 0;  ///< in any unit: only shares count
};

/// A point of the curve.
struct GradingPoint {
  double size = 0;     ///< [m]
  double passing = 0;  ///< share of the mass that is not larger [-]
};

/// A curve through points in ascending order, straight between them over the logarithm of size. Two
/// points of one size make a step; what the first point passes has the size of the first point.
class Grading {
 public:
  /// A step at every size, exact for grains that have been measured one by one.
  [[nodiscard]] static Grading of_fractions(std::vector<SizeFraction> fractions);

  /// The curve of a sieve analysis: the openings of the sieves, ascending, and what passes them;
  /// all passes the last one.
  [[nodiscard]] static Grading of_sieves(std::vector<GradingPoint> points);

  [[nodiscard]] std::span<const GradingPoint> points() const { return points_; }
  [[nodiscard]] double largest() const { return size_at(1); }  ///< [m]

  /// Share of the mass that is not larger than a size [m].
  [[nodiscard]] double passing(double size) const;

  /// The smallest size [m] that this share of the mass passes: D10 is size_at(0.10).
  /// @param share in (0, 1]
  [[nodiscard]] double size_at(double share) const;

  /// Area between the curve and the line up at `limit` [m], over the decimal logarithm of size [-]:
  /// the mean of log10(size / limit), where finer grains count as zero.
  [[nodiscard]] double area_above(double limit) const;

 private:
  Grading() = default;

  std::vector<GradingPoint> points_;
};

/// Of the free particles and of dust, by the diameter of the circle of equal area; boundary
/// particles do not break and are left out. A sieve sees the least width, which stays as it was
/// when a particle breaks across its length; this size shows every break. By mass: rocks of several
/// densities count with their own.
[[nodiscard]] Grading grading(const Particles& particles);
/// The same of one material, in clusters of several the cells of that one. Throws InvalidInput if
/// there is none of it.
[[nodiscard]] Grading grading(const Particles& particles, MaterialIndex material);

/// Of the intact particles that these were once: areas and masses of pieces and dust add up to
/// their root's.
[[nodiscard]] Grading grading_before_breakage(const Particles& particles);
[[nodiscard]] Grading grading_before_breakage(const Particles& particles, MaterialIndex material);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/measurement/grading.ipp>
#endif
