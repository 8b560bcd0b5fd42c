// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// By how much must the stresses in a particle change before it can break?

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <riprap/breakage/criterion/concepts.hpp>
#include <riprap/stress/compact_operator.hpp>

namespace riprap {

/// Radius of Mohr's circle at failure over its centre, as a table: a lower bound for any criterion
/// that keeps to its role. The curve of major_stress_at_failure rises at least as fast as the minor
/// stress does, so this radius rises with the centre, and never faster than it. A change of stress
/// of spectral norm x moves centre and radius by x at most in sum: what is left between a radius
/// and the one at failure is the least change by which the element can fail.
class FailureRadii {
 public:
  FailureRadii() = default;
  template <FailureCriterion C>
  [[nodiscard]] static FailureRadii of(const C& criterion) {
    FailureRadii radii;
    radii.tabulate(criterion);
    return radii;
  }

  [[nodiscard]] float step() const { return step_; }

  /// No circles about `centres` [Pa] with smaller radii have failed. Centres must be finite.
  void at_least(const Eigen::ArrayXf& centres, Eigen::ArrayXf& radii) {
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
    // From the next one, at the steepest. Round-off of places counts as a shift of the centre.
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
    if (step < 1e-12 || step > 1e25) {  // nothing is known in such units
      std::fill(radii_.begin(), radii_.end(), 0.0f);
      return;
    }
    step_ = static_cast<float>(step);
    inverse_step_ = 1 / step_;
    first_ = std::isfinite(tensile) ? -static_cast<float>(tensile)
                                    : -0.5f * step_ * static_cast<float>(count);
    radii_[0] = 0;  // nothing is known of centres below
    for (std::size_t i = 1; i < count; ++i) {
      const double centre =
          static_cast<double>(first_) + static_cast<double>(step_) * static_cast<double>(i);
      radii_[i] = static_cast<float>(radius_at_failure(criterion, centre, step));
    }
  }

  // By bisection, a little too small: the curve is rounded.
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

/// What one evaluation says about the next ones.
struct FailureOutlook {
  /// No more elements than these have failed.
  std::size_t possible = 0;
  /// After a change of all stresses of a smaller Frobenius norm fewer than `needed` have [Pa].
  double harmless_change = 0;
};

/// Counts the elements that may have failed, and finds the least change after which `needed` may
/// have.
class FailureForecast {
 public:
  FailureForecast() = default;
  explicit FailureForecast(FailureRadii radii)
      : radii_(std::move(radii)), inverse_unit_(2 / radii_.step()) {}

  [[nodiscard]] FailureOutlook operator()(const CompactStress& stress, std::size_t needed) {
    FailureOutlook outlook;
    if (!(stress.error < 1e30)) return {.possible = static_cast<std::size_t>(stress.elements)};
    const auto error = static_cast<float>(8 * stress.error);
    const auto half = 0.5f * (stress.component(0) - stress.component(1));
    centres_ = 0.5f * (stress.component(0) + stress.component(1));
    radii_.at_least(centres_, distances_);
    distances_ -= error + (half.square() + stress.component(2).square()).sqrt();
    distances_ *= inverse_unit_;
    std::array<std::uint16_t, bins> counts{};
    const float* const distances = distances_.data();
    for (Eigen::Index e = 0; e < stress.elements; ++e) {
      outlook.possible += !(distances[e] > 0);
      ++counts[bin(distances[e])];
    }
    // The `needed` least distances: those below the edge of a bin, and so many times that edge.
    std::size_t below = 0;
    std::size_t b = 0;
    while (b < bins && below + counts[b] < needed) below += counts[b++];
    if (b == bins) {
      outlook.harmless_change = std::numeric_limits<double>::infinity();
      return outlook;
    }
    // All elements count, up to the edge; those too many are taken off again.
    const float edge = lower_edge(b);
    const float all = distances_.max(0.0f).min(edge).square().sum();
    const auto elements = static_cast<float>(stress.elements);
    const float too_many = elements - static_cast<float>(needed) + 2e-5f * elements;
    outlook.harmless_change =
        static_cast<double>(std::sqrt(std::max(0.0f, all - too_many * edge * edge))) /
        static_cast<double>(inverse_unit_);
    return outlook;
  }

 private:
  // Eight bins to a doubling, read off the bits of a number: the first has all that is not above 1,
  // what may have failed included. Costs a fifth of sorting.
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

  FailureRadii radii_;
  float inverse_unit_ = 1;
  Eigen::ArrayXf centres_;
  Eigen::ArrayXf distances_;
};

}  // namespace riprap
