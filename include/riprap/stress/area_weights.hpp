// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The areas of sampling points as weights, in single precision.

#include <cstddef>
#include <vector>

#include <riprap/stress/sampling_points.hpp>

namespace riprap {

/// Of every point an upper bound on its area over the mean of all [-], in the order of the points.
[[nodiscard]] inline std::vector<float> area_weights(const SamplingPoints& points) {
  // Of single precision, and of the area of a mesh against that of its polygon.
  constexpr double round_off = 1e-6;
  double whole = 0;
  for (std::size_t i = 0; i < points.size(); ++i) whole += points.area(i);
  const double scale = (1 + round_off) * static_cast<double>(points.size()) / whole;
  std::vector<float> weights;
  for (std::size_t i = 0; i < points.size(); ++i)
    weights.push_back(static_cast<float>(scale * points.area(i)));
  return weights;
}

}  // namespace riprap
