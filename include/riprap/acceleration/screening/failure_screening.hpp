// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Screening: a lower bound on the change of stress after which a particle can break.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <riprap/acceleration/screening/influence_operator_f32.hpp>
#include <riprap/breakage/criterion/concepts.hpp>
#include <riprap/core/linkage.hpp>

namespace riprap {

/// Radius of Mohr's circle at failure as a function of its centre, tabulated: a lower bound for any
/// criterion that satisfies the axioms of its role. The curve of major_stress_at_failure rises at
/// least as fast as the minor stress, so this radius does not decrease with the centre, and rises
/// no faster than it. A change of stress of spectral norm x changes centre and radius by at most x
/// in sum: the distance of a radius from that at failure is the least change by which an element
/// can fail. For an OutOfPlaneCriterion the radius at failure may also fall, no faster than the
/// centre rises, and rise faster; the entries are then lowered accordingly.
class MohrRadiusTable {
 public:
  MohrRadiusTable() = default;
  template <Criterion C>
  [[nodiscard]] static MohrRadiusTable of(const C& criterion) {
    MohrRadiusTable radii;
    radii.tabulate(criterion);
    return radii;
  }

  [[nodiscard]] float step() const { return step_; }

  /// Lower bounds on the radii at failure of circles about `centres` [Pa], which must be finite.
  /// The radii are padded to whole vectors of four.
  void lower_bound(std::span<const float> centres, std::vector<float>& radii) const;

 private:
  static constexpr std::size_t count = 2048;
  static constexpr float last = count - 1.001f;

  template <class C>
  void tabulate(const C& criterion) {
    const double tensile = criterion.tensile_strength();
    const double uniaxial = criterion.major_stress_at_failure(0);
    const bool shears = std::isfinite(uniaxial) && uniaxial > 0;
    const double step =
        std::max(std::isfinite(tensile) ? tensile / 32 : 0, shears ? uniaxial / 512 : 0);
    radii_.assign(count, std::numeric_limits<float>::infinity());
    if (step == 0) return;              // nothing ever fails
    if (step < 1e-12 || step > 1e25) {  // beyond the range of single precision: no bound
      std::fill(radii_.begin(), radii_.end(), 0.0f);
      return;
    }
    step_ = static_cast<float>(step);
    inverse_step_ = 1 / step_;
    first_ = std::isfinite(tensile) ? -static_cast<float>(tensile)
                                    : -0.5f * step_ * static_cast<float>(count);
    radii_[0] = 0;  // no bound for centres below
    for (std::size_t i = 1; i < count; ++i) {
      const double centre =
          static_cast<double>(first_) + static_cast<double>(step_) * static_cast<double>(i);
      radii_[i] = static_cast<float>(radius_at_failure(criterion, centre, step));
    }
    if constexpr (OutOfPlaneCriterion<C>) lower_falling_radii();
  }

  // From the radii at the entries to lower bounds, from each entry to the next, on the least of the
  // radius at a lower centre plus the distance from there. No bound for centres above the last.
  void lower_falling_radii() {
    float below = std::numeric_limits<float>::infinity();
    for (float& radius : radii_) {
      const float here = radius;
      radius = std::min(here, below) - step_;
      below = std::min(here, below + step_);
    }
    radii_[count - 2] = radii_[count - 1] = 0;
  }

  // By bisection, reduced by more than the round-off of the curve.
  template <class C>
  [[nodiscard]] static double radius_at_failure(const C& criterion, double centre, double step) {
    const double tensile = criterion.tensile_strength();
    const auto intact = [&](double radius) {
      const auto [major, minor] = extreme_stresses(criterion, {centre + radius, centre - radius});
      return minor > -tensile && major < criterion.major_stress_at_failure(minor);
    };
    if (!intact(0)) return 0;
    double low = 0;
    double high = std::abs(centre) + step;
    while (std::isfinite(high) && intact(high)) {
      low = high;
      high *= 2;
    }
    if (!std::isfinite(high)) return low;
    for (int i = 0; i < 48; ++i) {
      const double middle = 0.5 * (low + high);
      (intact(middle) ? low : high) = middle;
    }
    return (1 - 1e-6) * low;
  }

  float first_ = 0;
  float step_ = 1;
  float inverse_step_ = 1;
  std::vector<float> radii_;
};

/// Result of the screening of one evaluation.
struct ScreeningResult {
  /// Upper bound on the number of failed elements.
  std::size_t possible = 0;
  /// Weighted norm of a change of all stresses below which fewer than `needed` elements fail [Pa].
  double stress_margin = 0;
};

/// Counts the elements that may have failed, and bounds the least change of stress after which
/// `needed` elements can have failed.
class FailureScreening {
 public:
  FailureScreening() = default;
  explicit FailureScreening(MohrRadiusTable radii)
      : radii_(std::move(radii)), inverse_unit_(2 / radii_.step()) {}

  [[nodiscard]] ScreeningResult operator()(const ElementStressF32& stress, std::size_t needed);
  /// The same where elements count by `weights`, of mean 1, up to `needed` in sum: that of the
  /// possibly failed ones may reach it if `possible` is not 0.
  [[nodiscard]] ScreeningResult operator()(const ElementStressF32& stress,
                                           std::span<const float> weights, double needed);

  /// By which the stresses of each element are multiplied in the norm of the last call, at most the
  /// root of its weight; zeros follow up to `stride` of the stresses.
  [[nodiscard]] std::span<const float> factors() const { return factors_; }

 private:
  // Part of the margin is spent on elements close to failure, whose stresses then do not count.
  static constexpr double given_up = 0.5;

  // Of sums of weights.
  [[nodiscard]] static double round_off(const ElementStressF32& stress) {
    return 2e-5 * static_cast<double>(stress.elements);
  }
  void find_distances(const ElementStressF32& stress);
  // `failed` is the sum of the weights of possibly failed elements.
  [[nodiscard]] ScreeningResult find_margin(const ElementStressF32& stress,
                                            std::span<const float> weights, double enough,
                                            double& failed);

  MohrRadiusTable radii_;
  float inverse_unit_ = 1;
  std::vector<float> centres_;
  std::vector<float> distances_;  // of every element from failure, in units of half a step
  std::vector<float> factors_;
  std::vector<float> ones_;
};

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/acceleration/screening/failure_screening.ipp>
#endif
