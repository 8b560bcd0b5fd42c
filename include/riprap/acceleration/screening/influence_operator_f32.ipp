// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <riprap/acceleration/screening/axis_form.hpp>
#include <riprap/acceleration/screening/influence_operator_f32.hpp>
#include <riprap/core/simd.hpp>
#include <riprap/stress/area_weights.hpp>

namespace riprap {

namespace internal {

[[nodiscard, gnu::always_inline]] inline FourFloats four_floats(const float* from) {
  return load_lanes<FourFloats>(from);
}

}  // namespace internal

RIPRAP_INLINE InfluenceOperatorF32::InfluenceOperatorF32(const InfluenceOperator& op)
    : locator_(op.locator()), quadratic_(!op.mesh().mid_sides.empty()),
      elements_(op.sampling_points().size()), stride_((elements_ + pad - 1) / pad * pad),
      area_weights_(riprap::area_weights(op.sampling_points())) {
  const Eigen::MatrixXd& exact = op.columns();
  const auto count = static_cast<std::size_t>(exact.cols());
  columns_.assign(3 * stride_ * count, 0);
  largest_.assign(locator_.nodes(), 0);
  const double* from = exact.data();
  for (std::size_t j = 0; j < count; ++j)
    for (std::size_t c = 0; c < 3; ++c, from += elements_) {
      float* const to = columns_.data() + (3 * j + c) * stride_;
      float& largest = largest_[j / 2];
      for (std::size_t e = 0; e < elements_; ++e) {
        to[e] = static_cast<float>(from[e]);
        largest = std::max(largest, std::abs(to[e]));
      }
    }
  find_largest_norm();
  for (std::uint32_t node = 0; node < locator_.nodes(); ++node)
    lengths_.push_back(static_cast<float>(
        (op.mesh().nodes[(node + 1) % locator_.nodes()] - op.mesh().nodes[node]).norm()));
}

RIPRAP_INLINE void InfluenceOperatorF32::find_stress(std::span<const BoundaryLoad> loads,
                                                     double scale, ElementStressF32& out) const {
  out.elements = elements_;
  out.stride = stride_;
  out.values.assign(3 * stride_, 0);
  double terms = 0;
  for (const BoundaryLoad& load : loads) {
    require_boundary_load(load.at, load.force_body, locator_.nodes());
    const NodalShares share = shares(load.at);
    const Vec2 near = scale * share.weights[0] * load.force_body;
    const Vec2 far = scale * share.weights[1] * load.force_body;
    const std::array<float, 4> factors{static_cast<float>(near.x()), static_cast<float>(near.y()),
                                       static_cast<float>(far.x()), static_cast<float>(far.y())};
    const float* const near_columns = columns(load.at.node);
    const float* const far_columns = columns(load.at.next);
    float* const sum = out.values.data();
    const std::size_t size = padded_size();
    for (std::size_t i = 0; i < size; i += 4)
      store_lanes(sum + i, internal::four_floats(sum + i) +
                               (factors[0] * internal::four_floats(near_columns + i) +
                                factors[1] * internal::four_floats(near_columns + size + i) +
                                factors[2] * internal::four_floats(far_columns + i) +
                                factors[3] * internal::four_floats(far_columns + size + i)));
    terms +=
        (std::abs(near.x()) + std::abs(near.y())) * static_cast<double>(largest_[load.at.node]) +
        (std::abs(far.x()) + std::abs(far.y())) * static_cast<double>(largest_[load.at.next]);
    if (share.count == 2) continue;
    const Vec2 rest = scale * share.weights[2] * load.force_body;
    const auto rest_x = static_cast<float>(rest.x());
    const auto rest_y = static_cast<float>(rest.y());
    const float* const third = columns(share.nodes[2]);
    for (std::size_t i = 0; i < size; i += 4)
      store_lanes(sum + i, internal::four_floats(sum + i) +
                               (rest_x * internal::four_floats(third + i) +
                                rest_y * internal::four_floats(third + size + i)));
    terms +=
        (std::abs(rest.x()) + std::abs(rest.y())) * static_cast<double>(largest_[share.nodes[2]]);
  }
  // Two roundings to single precision and one product per term, then the sum: half a unit in the
  // last place each, of at most the sum of the absolute terms. Twice that is assumed. No bound is
  // given for units beyond the range of single precision.
  const bool in_range = largest_norm_ > 1e-12 && largest_norm_ < 1e12;
  const std::size_t columns = (quadratic_ ? 6 : 4) * loads.size();
  out.error = in_range ? terms * static_cast<double>(columns + 4) * 0x1p-23
                       : std::numeric_limits<double>::infinity();
}

RIPRAP_INLINE void InfluenceOperatorF32::find_largest_norm() {
  const std::size_t size = padded_size();
  float largest = 0;
  for (std::uint32_t node = 0; node < locator_.nodes(); ++node) {
    const float* const x = columns(node);
    const float* const y = x + size;
    FourFloats xx{0, 0, 0, 0};
    FourFloats xy = xx;
    FourFloats yy = xx;
    for (std::size_t i = 0; i < size; i += 4) {
      const float times = i < 2 * stride_ ? 1 : 2;  // the shear
      const FourFloats along_x = internal::four_floats(x + i);
      const FourFloats along_y = internal::four_floats(y + i);
      xx += times * along_x * along_x;
      xy += times * along_x * along_y;
      yy += times * along_y * along_y;
    }
    largest = std::max(
        largest,
        AxisForm{lane_sum(xx), lane_sum(xy), lane_sum(xy), lane_sum(yy)}.largest_eigenvalue());
  }
  largest_norm_ = std::sqrt(static_cast<double>(largest));
  // Between nodes the absolute shares of quadratic shape functions sum up to 5/4.
  if (quadratic_) largest_norm_ *= 1.25;
}

}  // namespace riprap
