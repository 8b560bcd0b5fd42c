// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include <riprap/acceleration/screening/failure_screening.hpp>
#include <riprap/acceleration/screening/incremental_bound.hpp>
#include <riprap/core/simd.hpp>

namespace riprap {

namespace internal {

// Four numbers, or those that are left, and zeros.
[[nodiscard]] inline FourFloats load_some(std::span<const float> from) {
  std::array<float, 4> four{};
  std::copy_n(from.data(), std::min<std::size_t>(4, from.size()), four.data());
  return load_lanes<FourFloats>(four.data());
}

// Logarithmic histogram with eight bins per factor of two, from the bits of a number. The first bin
// has all distances up to 1, those of possibly failed elements included. Cheaper than sorting.
inline constexpr std::size_t distance_bins = 96;
inline constexpr std::int32_t first_distance_bin = std::bit_cast<std::int32_t>(1.0f) >> 20;

[[nodiscard]] inline std::size_t distance_bin(float distance) {
  const std::int32_t place = (std::bit_cast<std::int32_t>(distance) >> 20) - first_distance_bin;
  return static_cast<std::size_t>(std::clamp<std::int32_t>(place, 0, distance_bins - 1));
}
[[nodiscard]] inline float lower_edge(std::size_t bin) {
  if (bin == 0) return 0;
  return std::bit_cast<float>((first_distance_bin + static_cast<std::int32_t>(bin)) << 20);
}

}  // namespace internal

RIPRAP_INLINE void MohrRadiusTable::lower_bound(std::span<const float> centres,
                                                std::vector<float>& radii) const {
  radii.resize((centres.size() + 3) / 4 * 4);
  const float* const table = radii_.data();
  constexpr FourFloats zero{0, 0, 0, 0};
  constexpr FourFloats end{last, last, last, last};
  for (std::size_t k = 0; k < radii.size(); k += 4) {
    const FourFloats four = k + 4 <= centres.size() ? load_lanes<FourFloats>(centres.data() + k)
                                                    : internal::load_some(centres.subspan(k));
    const FourFloats places =
        smaller(larger(FourFloats((four - first_) * inverse_step_), zero), end);
    FourFloats here;
    FourFloats next;
    for (int l = 0; l < 4; ++l) {
      const int i = static_cast<int>(places[l]);
      here[l] = table[i];
      next[l] = table[i + 1] - static_cast<float>(i + 1) * step_;
    }
    // The larger of the two bounds from the neighbouring entries. Round-off of the position in the
    // table counts as a shift of the centre.
    store_lanes(radii.data() + k, larger(here, FourFloats(next + step_ * places)) - 1e-3f * step_);
  }
}

// Padded components: what lies behind the last element has the distance of a stress of zero.
RIPRAP_INLINE void FailureScreening::find_distances(const ElementStressF32& stress) {
  const auto error = static_cast<float>(8 * stress.error);
  const float* const s11 = stress.component(0).data();
  const float* const s22 = stress.component(1).data();
  const float* const s12 = stress.component(2).data();
  const auto load = [](const float* from) { return load_lanes<FourFloats>(from); };
  centres_.resize((stress.elements + 3) / 4 * 4);
  for (std::size_t e = 0; e < centres_.size(); e += 4)
    store_lanes(centres_.data() + e, 0.5f * (load(s11 + e) + load(s22 + e)));
  radii_.lower_bound(centres_, distances_);
  for (std::size_t e = 0; e < distances_.size(); e += 4) {
    const FourFloats half = 0.5f * (load(s11 + e) - load(s22 + e));
    const FourFloats shear = load(s12 + e);
    const FourFloats radius = square_root(FourFloats(half * half + shear * shear));
    store_lanes(distances_.data() + e,
                (load(distances_.data() + e) - (error + radius)) * inverse_unit_);
  }
}

RIPRAP_INLINE ScreeningResult FailureScreening::operator()(const ElementStressF32& stress,
                                                           std::size_t needed) {
  ones_.resize(stress.elements, 1.0f);
  double failed = 0;
  return find_margin(stress, ones_, static_cast<double>(needed), failed);
}

RIPRAP_INLINE ScreeningResult FailureScreening::operator()(const ElementStressF32& stress,
                                                           std::span<const float> weights,
                                                           double needed) {
  double failed = 0;
  ScreeningResult result = find_margin(stress, weights, needed - round_off(stress), failed);
  if (failed < needed - round_off(stress)) result.possible = 0;
  return result;
}

// Elements with distances d and weights w have failed only if their stresses have changed by d or
// more. A set whose weights reach n, without those with d < e, still has a weight of n less theirs:
// over it, and so over all elements with d >= e, the sum of w (change / d)^2 is no less than that.
RIPRAP_INLINE ScreeningResult FailureScreening::find_margin(const ElementStressF32& stress,
                                                            std::span<const float> weights,
                                                            double enough, double& failed) {
  factors_.assign(stress.stride, 0.0f);
  failed = std::numeric_limits<double>::infinity();
  if (!(stress.error < 1e30)) return {.possible = stress.elements};
  find_distances(stress);
  ScreeningResult result;
  // Sums of thousands of weights in single precision would err by too much.
  failed = 0;
  std::array<double, internal::distance_bins> sums{};
  for (std::size_t e = 0; e < stress.elements; ++e) {
    const auto weight = static_cast<double>(weights[e]);
    if (!(distances_[e] > 0)) {
      failed += weight;
      distances_[e] = 0;
      ++result.possible;
    }
    sums[internal::distance_bin(distances_[e])] += weight;
  }
  const double near_enough = failed + given_up * (enough - failed);
  double below = sums[0];
  std::size_t b = 1;
  while (b < sums.size() && below + sums[b] < near_enough) below += sums[b++];
  double all = below;
  for (std::size_t k = b; k < sums.size(); ++k) all += sums[k];
  if (all < enough) {
    result.stress_margin = std::numeric_limits<double>::infinity();
    return result;
  }
  const float edge = internal::lower_edge(b);
  const FourFloats edges{edge, edge, edge, edge};
  constexpr FourFloats zero{0, 0, 0, 0};
  for (std::size_t e = 0; e < stress.elements; e += 4) {
    const auto distance = load_lanes<FourFloats>(distances_.data() + e);
    const FourFloats weight = e + 4 <= weights.size() ? load_lanes<FourFloats>(weights.data() + e)
                                                      : internal::load_some(weights.subspan(e));
    const FourFloats factor = edges / distance * square_root(weight);
    store_lanes(factors_.data() + e, FourFloats(distance >= edges ? factor : zero));
  }
  result.stress_margin = static_cast<double>(edge) * std::sqrt(std::max(0.0, enough - below)) /
                         static_cast<double>(inverse_unit_);
  return result;
}

}  // namespace riprap
