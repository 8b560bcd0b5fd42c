// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Screening: a lower bound on the change of stress after which a particle can break.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <riprap/breakage/criterion/concepts.hpp>
#include <riprap/acceleration/screening/influence_operator_f32.hpp>

namespace riprap {

/// Radius of Mohr's circle at failure as a function of its centre, tabulated: a lower bound for any
/// criterion that satisfies the axioms of its role. The curve of major_stress_at_failure rises at
/// least as fast as the minor stress, so this radius does not decrease with the centre, and rises
/// no faster than it. A change of stress of spectral norm x changes centre and radius by at most x
/// in sum: the distance of a radius from that at failure is the least change by which an element
/// can fail.
class MohrRadiusTable {
 public:
  MohrRadiusTable() = default;
  template <FailureCriterion C>
  [[nodiscard]] static MohrRadiusTable of(const C& criterion) {
    MohrRadiusTable radii;
    radii.tabulate(criterion);
    return radii;
  }

  [[nodiscard]] float step() const { return step_; }

  /// Lower bounds on the radii at failure of circles about `centres` [Pa], which must be finite.
  void lower_bound(const Eigen::ArrayXf& centres, Eigen::ArrayXf& radii) {
    places_ = ((centres - first_) * inverse_step_).max(0.0f).min(last);
    radii.resize(centres.size());
    next_.resize(centres.size());
    const float* const table = radii_.data();
    const float* const places = places_.data();
    float* const here = radii.data();
    float* const next = next_.data();
    for (Eigen::Index k = 0; k < centres.size(); ++k) {
      const int i = static_cast<int>(places[k]);
      here[k] = table[i];
      next[k] = table[i + 1] - static_cast<float>(i + 1) * step_;
    }
    // The larger of the two bounds from the neighbouring entries. Round-off of the position in the
    // table counts as a shift of the centre.
    radii = radii.max(next_ + step_ * places_) - 1e-3f * step_;
  }

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
  }

  // By bisection, reduced by more than the round-off of the curve.
  template <class C>
  [[nodiscard]] static double radius_at_failure(const C& criterion, double centre, double step) {
    const double tensile = criterion.tensile_strength();
    const auto intact = [&](double radius) {
      const double minor = centre - radius;
      return minor > -tensile && centre + radius < criterion.major_stress_at_failure(minor);
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
  Eigen::ArrayXf places_;
  Eigen::ArrayXf next_;
};

/// Result of the screening of one evaluation.
struct ScreeningResult {
  /// Upper bound on the number of failed elements.
  std::size_t possible = 0;
  /// Frobenius norm of a change of all stresses below which fewer than `needed` elements fail [Pa].
  double stress_margin = 0;
};

/// Counts the elements that may have failed, and bounds the least change of stress after which
/// `needed` elements can have failed.
class FailureScreening {
 public:
  FailureScreening() = default;
  explicit FailureScreening(MohrRadiusTable radii)
      : radii_(std::move(radii)), inverse_unit_(2 / radii_.step()) {}

  [[nodiscard]] ScreeningResult operator()(const ElementStressF32& stress, std::size_t needed) {
    ScreeningResult result;
    if (!(stress.error < 1e30)) return {.possible = static_cast<std::size_t>(stress.elements)};
    const auto error = static_cast<float>(8 * stress.error);
    const auto half = 0.5f * (stress.component(0) - stress.component(1));
    centres_ = 0.5f * (stress.component(0) + stress.component(1));
    radii_.lower_bound(centres_, distances_);
    distances_ -= error + (half.square() + stress.component(2).square()).sqrt();
    distances_ *= inverse_unit_;
    std::array<std::uint16_t, bins> counts{};
    const float* const distances = distances_.data();
    for (Eigen::Index e = 0; e < stress.elements; ++e) {
      result.possible += !(distances[e] > 0);
      ++counts[bin(distances[e])];
    }
    // Sum of squares of the `needed` least distances, with those in and above the last bin rounded
    // down to its lower edge.
    std::size_t below = 0;
    std::size_t b = 0;
    while (b < bins && below + counts[b] < needed) below += counts[b++];
    if (b == bins) {
      result.stress_margin = std::numeric_limits<double>::infinity();
      return result;
    }
    // Sum over all elements, truncated at the edge, less the surplus elements.
    const float edge = lower_edge(b);
    const float all = distances_.max(0.0f).min(edge).square().sum();
    const auto elements = static_cast<float>(stress.elements);
    const float too_many = elements - static_cast<float>(needed) + 2e-5f * elements;
    result.stress_margin =
        static_cast<double>(std::sqrt(std::max(0.0f, all - too_many * edge * edge))) /
        static_cast<double>(inverse_unit_);
    return result;
  }

 private:
  // Logarithmic histogram with eight bins per factor of two, from the bits of a number. The first
  // bin has all distances up to 1, those of possibly failed elements included. Cheaper than
  // sorting.
  static constexpr std::size_t bins = 96;
  static constexpr std::int32_t first_bin = std::bit_cast<std::int32_t>(1.0f) >> 20;

  [[nodiscard]] static std::size_t bin(float distance) {
    const std::int32_t place = (std::bit_cast<std::int32_t>(distance) >> 20) - first_bin;
    return static_cast<std::size_t>(std::clamp<std::int32_t>(place, 0, bins - 1));
  }
  [[nodiscard]] static float lower_edge(std::size_t bin) {
    if (bin == 0) return 0;
    return std::bit_cast<float>((first_bin + static_cast<std::int32_t>(bin)) << 20);
  }

  MohrRadiusTable radii_;
  float inverse_unit_ = 1;
  Eigen::ArrayXf centres_;
  Eigen::ArrayXf distances_;
};

}  // namespace riprap
