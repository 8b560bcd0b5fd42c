// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <riprap/acceleration/screening/incremental_bound.hpp>
#include <riprap/acceleration/screening/influence_operator_f32.hpp>
#include <riprap/core/simd.hpp>

namespace riprap {

namespace internal {

[[nodiscard, gnu::always_inline]] inline FourFloats four_floats(const float* from) {
  return load_lanes<FourFloats>(from);
}

[[nodiscard]] inline float lane_sum(const FourFloats& v) { return (v[0] + v[1]) + (v[2] + v[3]); }

// Largest eigenvalue of a symmetric, non-negative form.
[[nodiscard]] inline double largest_eigenvalue(const AxisForm& form) {
  const auto xx = static_cast<double>(form.xx);
  const auto yy = static_cast<double>(form.yy);
  const double half = 0.5 * (xx - yy);
  const double off = 0.5 * (static_cast<double>(form.xy) + static_cast<double>(form.yx));
  return 0.5 * (xx + yy) + std::sqrt(half * half + off * off);
}

}  // namespace internal

RIPRAP_INLINE InfluenceOperatorF32::InfluenceOperatorF32(const InfluenceOperator& op)
    : locator_(op.locator()), quadratic_(!op.mesh().mid_sides.empty()),
      elements_(op.sampling_points().size()), stride_((elements_ + pad - 1) / pad * pad),
      areas_(op.sampling_points()) {
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
  sum_products();
  find_position_sensitivity(op.mesh());
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
    const float* const near_columns = column(2 * std::size_t{load.at.node});
    const float* const far_columns = column(2 * std::size_t{load.at.next});
    float* const sum = out.values.data();
    const std::size_t size = 3 * stride_;
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
    const float* const third = column(2 * std::size_t{share.nodes[2]});
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

RIPRAP_INLINE AxisForm InfluenceOperatorF32::product(const BoundaryPoint& a,
                                                     const BoundaryPoint& b) const {
  if (quadratic_) return quadratic_product(a, b);
  const auto w = static_cast<float>(a.weight);
  const auto v = static_cast<float>(b.weight);
  const std::array<AxisForm, 4> blocks{block(a.node, b.node), block(a.node, b.next),
                                       block(a.next, b.node), block(a.next, b.next)};
  const std::array<float, 4> weights{w * v, w * (1 - v), (1 - w) * v, (1 - w) * (1 - v)};
  const auto sum = [&](float AxisForm::*of) {
    return weights[0] * blocks[0].*of + weights[1] * blocks[1].*of + weights[2] * blocks[2].*of +
           weights[3] * blocks[3].*of;
  };
  return {sum(&AxisForm::xx), sum(&AxisForm::xy), sum(&AxisForm::yx), sum(&AxisForm::yy)};
}

RIPRAP_INLINE AxisForm InfluenceOperatorF32::quadratic_product(const BoundaryPoint& a,
                                                               const BoundaryPoint& b) const {
  const NodalShares p = shares(a);
  const NodalShares q = shares(b);
  AxisForm sum;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const auto weight = static_cast<float>(p.weights[i] * q.weights[j]);
      const AxisForm one = block(p.nodes[i], q.nodes[j]);
      sum.xx += weight * one.xx;
      sum.xy += weight * one.xy;
      sum.yx += weight * one.yx;
      sum.yy += weight * one.yy;
    }
  return sum;
}

RIPRAP_INLINE double InfluenceOperatorF32::position_sensitivity(const BoundaryPoint& at,
                                                                const Vec2& force) const {
  const std::uint32_t nodes = locator_.nodes();
  const auto x = static_cast<float>(force.x());
  const auto y = static_cast<float>(force.y());
  float largest = 0;
  for (const std::uint32_t node : {(at.node + nodes - 1) % nodes, at.node, at.next})
    for (std::uint32_t end = 0; end < ends(); ++end) {
      const Segment& segment = segments_[node * ends() + end];
      largest = std::max(largest, x * (x * segment.xx + y * segment.xy) + y * y * segment.yy);
    }
  return std::sqrt(static_cast<double>(largest));
}

RIPRAP_INLINE double InfluenceOperatorF32::position_sensitivity(const BoundaryPoint& at) const {
  const std::uint32_t nodes = locator_.nodes();
  float steepest = 0;
  for (const std::uint32_t node : {(at.node + nodes - 1) % nodes, at.node, at.next})
    for (std::uint32_t end = 0; end < ends(); ++end)
      steepest = std::max(steepest, segments_[node * ends() + end].position_sensitivity);
  return static_cast<double>(steepest);
}

RIPRAP_INLINE AxisForm InfluenceOperatorF32::block(std::uint32_t i, std::uint32_t j) const {
  const auto stored = [this](std::uint32_t row, std::uint32_t column) -> const AxisForm& {
    return products_[row * (row + 1) / 2 + column];
  };
  if (i >= j) return stored(i, j);
  const AxisForm& mirrored = stored(j, i);
  return {mirrored.xx, mirrored.yx, mirrored.xy, mirrored.yy};
}

// Of two columns, or what is laid out like them, the shear twice.
RIPRAP_INLINE float InfluenceOperatorF32::stress_product(const float* a, const float* b) const {
  const auto sum_of = [&](std::size_t first, std::size_t last) {
    FourFloats even{0, 0, 0, 0};
    FourFloats odd{0, 0, 0, 0};
    for (std::size_t i = first; i < last; i += pad) {
      even += internal::four_floats(a + i) * internal::four_floats(b + i);
      odd += internal::four_floats(a + i + 4) * internal::four_floats(b + i + 4);
    }
    return even + odd;
  };
  return internal::lane_sum(sum_of(0, 2 * stride_) + 2 * sum_of(2 * stride_, 3 * stride_));
}

RIPRAP_INLINE void InfluenceOperatorF32::sum_products() {
  const std::size_t nodes = locator_.nodes();
  products_.reserve(nodes * (nodes + 1) / 2);
  for (std::size_t i = 0; i < nodes; ++i)
    for (std::size_t j = 0; j <= i; ++j)
      products_.push_back({stress_product(column(2 * i), column(2 * j)),
                           stress_product(column(2 * i), column(2 * j + 1)),
                           stress_product(column(2 * i + 1), column(2 * j)),
                           stress_product(column(2 * i + 1), column(2 * j + 1))});
}

// Derivatives of the shares of a node, the next and the third of their side, along the segment from
// the node in units of its length: at an end of it, 0 or 1.
RIPRAP_INLINE std::array<float, 3> InfluenceOperatorF32::slopes(std::uint32_t node,
                                                                std::uint32_t end) const {
  if (!quadratic_) return {-1, 1, 0};
  if (node % 2 == 0)  // a corner and its mid-side node
    return end == 0 ? std::array{-1.5f, 2.0f, -0.5f} : std::array{-0.5f, 0.0f, 0.5f};
  return end == 0 ? std::array{0.0f, 0.5f, -0.5f} : std::array{-2.0f, 1.5f, 0.5f};
}

RIPRAP_INLINE void InfluenceOperatorF32::find_position_sensitivity(const Mesh& mesh) {
  const std::uint32_t nodes = locator_.nodes();
  const std::size_t size = 3 * stride_;
  std::vector<float> change(2 * size);
  for (std::uint32_t j = 0; j < nodes; ++j) {
    const std::uint32_t k = (j + 1) % nodes;
    largest_norm_ = std::max(largest_norm_, std::sqrt(internal::largest_eigenvalue(block(j, j))));
    const NodalShares side = shares({j, k, 1});
    const double length = (mesh.nodes[k] - mesh.nodes[j]).norm();
    const auto per_square = static_cast<float>(1 / (length * length));
    for (std::uint32_t end = 0; end < ends(); ++end) {
      const std::array<float, 3> slope = slopes(j, end);
      const float* const near = column(2 * std::size_t{j});
      const float* const far = column(2 * std::size_t{k});
      for (std::size_t i = 0; i < 2 * size; i += 4)
        store_lanes(change.data() + i, slope[0] * internal::four_floats(near + i) +
                                           slope[1] * internal::four_floats(far + i));
      if (side.count == 3) {
        const float* const third = column(2 * std::size_t{side.nodes[2]});
        for (std::size_t i = 0; i < 2 * size; i += 4)
          store_lanes(change.data() + i, internal::four_floats(change.data() + i) +
                                             slope[2] * internal::four_floats(third + i));
      }
      const float* const x = change.data();
      const float* const y = change.data() + size;
      const float xy = per_square * stress_product(x, y);
      const AxisForm form{per_square * stress_product(x, x), xy, xy,
                          per_square * stress_product(y, y)};
      // Round-off of the columns themselves is 6e-8 of them, and nodes are not near each other.
      const float off = 1e-4f * (form.xx + form.yy);
      segments_.push_back({form.xx + off, 2 * form.xy, form.yy + off,
                           static_cast<float>(std::sqrt(internal::largest_eigenvalue(form) +
                                                        static_cast<double>(off))),
                           static_cast<float>(length)});
    }
  }
  // Between nodes the absolute shares of quadratic shape functions sum up to 5/4.
  if (quadratic_) largest_norm_ *= 1.25;
}

}  // namespace riprap
