// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The grading curve: which share of a sample's mass is finer than a size.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include <riprap/core/errors.hpp>
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
  [[nodiscard]] static Grading of_fractions(std::vector<SizeFraction> fractions) {
    for (const SizeFraction& f : fractions) {
      require_positive("SizeFraction.size", f.size);
      require_non_negative("SizeFraction.mass", f.mass);
    }
    std::sort(fractions.begin(), fractions.end(), [](const auto& p, const auto& q) {
      return std::pair(p.size, p.mass) < std::pair(q.size, q.mass);
    });
    double total = 0;
    for (const SizeFraction& f : fractions) total += f.mass;
    require_positive("Grading: mass of all fractions", total);
    Grading grading;
    double finer = 0;
    for (const SizeFraction& f : fractions) {
      grading.points_.push_back({f.size, finer / total});
      finer += f.mass;
      grading.points_.push_back({f.size, finer / total});
    }
    return grading;
  }

  /// The curve of a sieve analysis: the openings of the sieves, ascending, and what passes them;
  /// all passes the last one.
  [[nodiscard]] static Grading of_sieves(std::vector<GradingPoint> points) {
    GradingPoint before;
    for (const GradingPoint& p : points) {
      require_positive("GradingPoint.size", p.size);
      require(p.size >= before.size, "GradingPoint.size", p.size, "must not descend");
      require(p.passing >= before.passing && p.passing <= 1, "GradingPoint.passing", p.passing,
              "must lie in [0, 1] and not descend");
      before = p;
    }
    require(before.passing == 1, "GradingPoint.passing of the last point", before.passing,
            "must be 1");
    Grading grading;
    grading.points_ = std::move(points);
    return grading;
  }

  [[nodiscard]] std::span<const GradingPoint> points() const { return points_; }
  [[nodiscard]] double largest() const { return size_at(1); }  ///< [m]

  /// Share of the mass that is not larger than a size [m].
  [[nodiscard]] double passing(double size) const {
    const auto next = std::upper_bound(points_.begin(), points_.end(), size,
                                       [](double s, const GradingPoint& p) { return s < p.size; });
    if (next == points_.begin()) return 0;
    const GradingPoint& p = *(next - 1);
    if (next == points_.end()) return 1;
    return p.passing +
           (next->passing - p.passing) * std::log(size / p.size) / std::log(next->size / p.size);
  }

  /// The smallest size [m] that this share of the mass passes: D10 is size_at(0.10).
  /// @param share in (0, 1]
  [[nodiscard]] double size_at(double share) const {
    require(share > 0 && share <= 1, "share that passes", share, "must lie in (0, 1]");
    const auto next =
        std::lower_bound(points_.begin(), points_.end(), share,
                         [](const GradingPoint& p, double s) { return p.passing < s; });
    if (next == points_.begin()) return next->size;
    const GradingPoint& p = *(next - 1);
    return p.size *
           std::pow(next->size / p.size, (share - p.passing) / (next->passing - p.passing));
  }

  /// Area between the curve and the line up at `limit` [m], over the decimal logarithm of size [-]:
  /// the mean of log10(size / limit), where finer grains count as zero.
  [[nodiscard]] double area_above(double limit) const {
    require_positive("lower limit of size", limit);
    double area = 0;
    double before = 0;
    double from = std::log10(points_.front().size / limit);
    for (const GradingPoint& p : points_) {
      const double to = std::log10(p.size / limit);
      const double share = p.passing - before;
      if (from >= 0)
        area += share * 0.5 * (from + to);
      else if (to > 0)
        area += share * 0.5 * to * to / (to - from);
      before = p.passing;
      from = to;
    }
    return area;
  }

 private:
  Grading() = default;

  std::vector<GradingPoint> points_;
};

/// Of the free particles, by the diameter of the circle of equal area; boundary particles do not
/// break and are left out. A sieve sees the least width, which stays as it was when a particle
/// breaks across its length; this size shows every break. All rock has one density and thickness,
/// so area stands for mass.
[[nodiscard]] inline Grading grading(const Particles& particles) {
  std::vector<SizeFraction> fractions;
  for (BodyIndex i = 0; i < particles.size(); ++i) {
    const double area = particles.shape(i).area;
    if (particles.body(i).is_free()) fractions.push_back({equivalent_diameter(area), area});
  }
  return Grading::of_fractions(std::move(fractions));
}

/// Of the intact particles that the free ones were once: the areas of pieces add up to their
/// root's.
[[nodiscard]] inline Grading grading_before_breakage(const Particles& particles) {
  std::map<ParticleId, double> roots;  // areas
  for (BodyIndex i = 0; i < particles.size(); ++i)
    if (particles.body(i).is_free()) roots[particles.ancestry(i).root] += particles.shape(i).area;
  std::vector<SizeFraction> fractions;
  for (const auto& [id, area] : roots) fractions.push_back({equivalent_diameter(area), area});
  return Grading::of_fractions(std::move(fractions));
}

}  // namespace riprap
