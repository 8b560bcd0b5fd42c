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
  explicit FailureRadii(const C& criterion) {
    const double tensile = criterion.tensile_strength();
    const double uniaxial = criterion.major_stress_at_failure(0);
    const bool shears = std::isfinite(uniaxial) && uniaxial > 0;
    const double step =
        std::max(std::isfinite(tensile) ? tensile / 32 : 0, shears ? uniaxial / 512 : 0);
    radii_.assign(count, std::numeric_limits<float>::infinity());
    step_ = static_cast<float>(step > 0 ? step : 1);
    inverse_step_ = 1 / step_;
    first_ = std::isfinite(tensile) ? -static_cast<float>(tensile)
                                    : -step_ * static_cast<float>(count / 2);
    if (step == 0) return;  // nothing ever fails
    radii_[0] = 0;          // nothing is known of centres below
    for (std::size_t i = 1; i < count; ++i) {
      const double centre =
          static_cast<double>(first_) + static_cast<double>(step_) * static_cast<double>(i);
      radii_[i] = static_cast<float>(radius_at_failure(criterion, centre, step));
    }
  }

  [[nodiscard]] float step() const { return step_; }

  /// No circle about `centre` [Pa] with a smaller radius has failed.
  [[nodiscard]] float at_least(float centre) const {
    float place = (centre - first_) * inverse_step_;
    place = place > 0 ? place : 0;
    place = place < last ? place : last;
    const auto i = static_cast<std::size_t>(place);
    const float rest = (static_cast<float>(i + 1) - place) * step_;
    // Round-off of `place` counts as a shift of the centre.
    return std::max(radii_[i], radii_[i + 1] - rest) - 5e-4f * step_;
  }

 private:
  static constexpr std::size_t count = 2048;
  static constexpr float last = count - 1.001f;

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
  explicit FailureForecast(FailureRadii radii) : radii_(std::move(radii)) {}

  [[nodiscard]] FailureOutlook operator()(const CompactStress& stress, std::size_t needed) const {
    std::array<std::uint16_t, bins> counts{};
    FailureOutlook outlook;
    const auto error = static_cast<float>(8 * stress.error);
    const float unit = radii_.step() / 16;
    const float* s11 = stress.values.data();
    const float* s22 = s11 + stress.stride;
    const float* s12 = s22 + stress.stride;
    for (Eigen::Index e = 0; e < stress.elements; ++e) {
      const float half = 0.5f * (s11[e] - s22[e]);
      const float radius = std::sqrt(half * half + s12[e] * s12[e]) + error;
      const float distance = radii_.at_least(0.5f * (s11[e] + s22[e])) - radius;
      if (distance > 0)
        ++counts[bin(distance / unit)];
      else
        ++outlook.possible;
    }
    if (outlook.possible >= needed) return outlook;
    std::size_t left = needed - outlook.possible;
    double sum = 0;
    for (std::size_t b = 0; b < bins && left > 0; ++b) {
      if (counts[b] == 0) continue;
      const auto taken = std::min<std::size_t>(left, counts[b]);
      const double edge = lower_edge(b);
      sum += static_cast<double>(taken) * edge * edge;
      left -= taken;
    }
    outlook.harmless_change = left > 0 ? std::numeric_limits<double>::infinity()
                                       : static_cast<double>(unit) * std::sqrt(sum);
    return outlook;
  }

 private:
  // Eight bins to a doubling, read off the bits of a number: sorting by a bin each loses three per
  // cent of the distance on average, and costs a fifth of sorting.
  static constexpr std::size_t bins = 144;
  static constexpr std::uint32_t first_bin = std::bit_cast<std::uint32_t>(1.0f) >> 20;

  [[nodiscard]] static std::size_t bin(float distance) {
    const std::uint32_t place = std::bit_cast<std::uint32_t>(distance) >> 20;
    return std::clamp<std::uint32_t>(place, first_bin, first_bin + bins - 1) - first_bin;
  }
  [[nodiscard]] static double lower_edge(std::size_t bin) {
    if (bin == 0) return 0;
    return static_cast<double>(
        std::bit_cast<float>((first_bin + static_cast<std::uint32_t>(bin)) << 20));
  }

  FailureRadii radii_;
};

}  // namespace riprap
