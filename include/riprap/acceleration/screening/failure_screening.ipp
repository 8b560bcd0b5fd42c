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
  ScreeningResult result;
  if (!(stress.error < 1e30)) return {.possible = stress.elements};
  find_distances(stress);
  std::array<std::uint16_t, internal::distance_bins> counts{};
  const float* const distances = distances_.data();
  for (std::size_t e = 0; e < stress.elements; ++e) {
    result.possible += !(distances[e] > 0);
    ++counts[internal::distance_bin(distances[e])];
  }
  // Sum of squares of the `needed` least distances, with those in and above the last bin rounded
  // down to its lower edge.
  std::size_t below = 0;
  std::size_t b = 0;
  while (b < counts.size() && below + counts[b] < needed) below += counts[b++];
  if (b == counts.size()) {
    result.stress_margin = std::numeric_limits<double>::infinity();
    return result;
  }
  // Sum over all elements, truncated at the edge, less the surplus elements.
  const float edge = internal::lower_edge(b);
  std::fill(distances_.begin() + static_cast<std::ptrdiff_t>(stress.elements), distances_.end(), 0);
  constexpr FourFloats zero{0, 0, 0, 0};
  FourFloats sums = zero;
  for (std::size_t e = 0; e < distances_.size(); e += 4) {
    const auto distance = load_lanes<FourFloats>(distances + e);
    const FourFloats truncated =
        smaller(larger(distance, zero), FourFloats{edge, edge, edge, edge});
    sums += truncated * truncated;
  }
  const float all = (sums[0] + sums[1]) + (sums[2] + sums[3]);
  const auto elements = static_cast<float>(stress.elements);
  const float too_many = elements - static_cast<float>(needed) + 2e-5f * elements;
  result.stress_margin =
      static_cast<double>(std::sqrt(std::max(0.0f, all - too_many * edge * edge))) /
      static_cast<double>(inverse_unit_);
  return result;
}

// A set of elements with weights w and distances d whose weights reach the needed sum n needs a
// change of at least the sum of its d^2. For any edge e that is not less than the sum over all of
// min(d^2, w e^2), less e^2 times the weight that is left out, at most that of all less n. The best
// edge is where the weights of elements in the order of d / sqrt(w) reach n.
RIPRAP_INLINE ScreeningResult FailureScreening::operator()(const ElementStressF32& stress,
                                                           std::span<const float> weights,
                                                           double needed) {
  if (!(stress.error < 1e30)) return {.possible = stress.elements};
  find_distances(stress);
  const double round_off = 2e-5 * static_cast<double>(stress.elements);  // of the squares
  const double enough = needed - round_off;
  ScreeningResult result;
  // Sums of thousands of weights in single precision would err by more than that.
  double failed = 0;
  double all = 0;
  std::array<double, internal::distance_bins> sums{};
  for (std::size_t e = 0; e < stress.elements; ++e) {
    const auto weight = static_cast<double>(weights[e]);
    all += weight;
    if (!(distances_[e] > 0)) {
      failed += weight;
      distances_[e] = 0;
      ++result.possible;
    }
    sums[internal::distance_bin(distances_[e] / std::sqrt(weights[e]))] += weight;
  }
  if (failed < enough) result.possible = 0;
  double below = 0;
  std::size_t b = 0;
  while (b < sums.size() && below + sums[b] < enough) below += sums[b++];
  if (b == sums.size()) {
    result.stress_margin = std::numeric_limits<double>::infinity();
    return result;
  }
  const float edge = internal::lower_edge(b);
  double squares = 0;
  for (std::size_t e = 0; e < stress.elements; ++e)
    squares +=
        static_cast<double>(std::min(distances_[e] * distances_[e], weights[e] * edge * edge));
  const double left_out = (all - enough + round_off) * static_cast<double>(edge * edge);
  result.stress_margin =
      std::sqrt(std::max(0.0, squares - left_out)) / static_cast<double>(inverse_unit_);
  return result;
}

}  // namespace riprap
