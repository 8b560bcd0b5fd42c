// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Upper bounds on the area that a number of sampling points can stand for.

#include <algorithm>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include <riprap/stress/sampling_points.hpp>

namespace riprap {

/// For every n, an upper bound on the share of a particle's area that any n of its sampling points
/// stand for: that of the n largest, in single precision and rounded up.
class LargestAreas {
 public:
  LargestAreas() = default;
  explicit LargestAreas(const SamplingPoints& points) {
    std::vector<double> areas(points.size());
    for (std::size_t i = 0; i < areas.size(); ++i) areas[i] = points.area(i);
    std::sort(areas.begin(), areas.end(), std::greater<>{});
    double whole = 0;
    for (const double area : areas) whole += area;
    for (std::size_t i = 0; i < areas.size(); ++i)
      weights_.push_back(static_cast<float>((1 + round_off) * static_cast<double>(areas.size()) *
                                            points.area(i) / whole));
    double sum = 0;
    for (const double area : areas)
      shares_.push_back(static_cast<float>((1 + round_off) * (sum += area) / whole));
  }

  /// Number of sampling points.
  [[nodiscard]] std::size_t size() const { return shares_.size(); }
  /// Of every point an upper bound on its area over the mean of all [-], in the order of the
  /// points.
  [[nodiscard]] std::span<const float> weights() const { return weights_; }
  /// The fewest points that can stand for `share` [-] of the area; one more than there are if all
  /// do not.
  [[nodiscard]] std::size_t points_for(double share) const {
    const auto reaches = [share](float bound) { return static_cast<double>(bound) >= share; };
    const auto found = std::find_if(shares_.begin(), shares_.end(), reaches);
    return static_cast<std::size_t>(found - shares_.begin()) + 1;
  }
  [[nodiscard]] std::size_t bytes() const {
    return sizeof(float) * (shares_.size() + weights_.size());
  }

 private:
  // Of single precision, and of the area of a mesh against that of its polygon.
  static constexpr double round_off = 1e-6;

  std::vector<float> shares_;  // of the 1, 2, ... largest points
  std::vector<float> weights_;
};

}  // namespace riprap
