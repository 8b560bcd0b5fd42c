// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <riprap/acceleration/screening/weighted_influence.hpp>
#include <riprap/core/simd.hpp>
#include <riprap/stress/nodal_shares.hpp>

namespace riprap {

namespace internal {

[[nodiscard]] inline FourFloats four_times(double number) {
  const auto f = static_cast<float>(number);
  return FourFloats{f, f, f, f};
}

}  // namespace internal

RIPRAP_INLINE void WeightedInfluence::assign(const InfluenceOperatorF32& op,
                                             std::span<const BoundaryLoad> loads,
                                             std::span<const LocatedPoint> places,
                                             std::span<const float> factors) {
  size_ = op.padded_size();
  const std::size_t stride = size_ / 3;
  factors_.resize(size_);
  float largest = 0;
  for (std::size_t e = 0; e < stride; ++e) {
    factors_[e] = factors_[stride + e] = factors[e];
    factors_[2 * stride + e] = std::numbers::sqrt2_v<float> * factors[e];
    largest = std::max(largest, factors[e]);
  }
  largest_norm_ = static_cast<double>(largest) * op.largest_norm();
  shape_factor_ = op.shape_factor();
  columns_.resize(loads.size() * 2 * size_);
  sensitivities_.resize(loads.size());
  for (std::size_t c = 0; c < loads.size(); ++c) {
    weight_columns(op, loads[c].at, columns_.data() + c * 2 * size_);
    sensitivities_[c] = find_sensitivity(op, loads[c], places[c]);
  }
}

RIPRAP_INLINE AxisForm WeightedInfluence::product(std::size_t c, std::size_t d) const {
  const float* const x = columns(c);
  const float* const y = x + size_;
  const float* const p = columns(d);
  const float* const q = p + size_;
  FourFloats xp{0, 0, 0, 0};
  FourFloats xq = xp;
  FourFloats yp = xp;
  FourFloats yq = xp;
  for (std::size_t i = 0; i < size_; i += 4) {
    const auto along_x = load_lanes<FourFloats>(x + i);
    const auto along_y = load_lanes<FourFloats>(y + i);
    const auto along_p = load_lanes<FourFloats>(p + i);
    const auto along_q = load_lanes<FourFloats>(q + i);
    xp += along_x * along_p;
    xq += along_x * along_q;
    yp += along_y * along_p;
    yq += along_y * along_q;
  }
  return {lane_sum(xp), lane_sum(xq), lane_sum(yp), lane_sum(yq)};
}

RIPRAP_INLINE void WeightedInfluence::weight_columns(const InfluenceOperatorF32& op,
                                                     const BoundaryPoint& point, float* to) const {
  const NodalShares share = op.shares(point);
  const FourFloats near = internal::four_times(share.weights[0]);
  const FourFloats far = internal::four_times(share.weights[1]);
  const FourFloats third = internal::four_times(share.weights[2]);
  const float* const a = op.columns(share.nodes[0]);
  const float* const b = op.columns(share.nodes[1]);
  const float* const c =
      op.columns(share.nodes[share.count - 1]);  // with a share of zero if linear
  for (std::size_t axis = 0; axis < 2 * size_; axis += size_)
    for (std::size_t i = 0; i < size_; i += 4) {
      const std::size_t at = axis + i;
      store_lanes(to + at, load_lanes<FourFloats>(factors_.data() + i) *
                               (near * load_lanes<FourFloats>(a + at) +
                                far * load_lanes<FourFloats>(b + at) +
                                third * load_lanes<FourFloats>(c + at)));
    }
}

// The derivative of the stresses along the segment from a node is linear at most, so that its norm
// is the largest at an end of what the point can reach.
RIPRAP_INLINE PositionSensitivity WeightedInfluence::find_sensitivity(
    const InfluenceOperatorF32& op, const BoundaryLoad& load, const LocatedPoint& place) const {
  const std::uint32_t nodes = op.locator().nodes();
  const auto before = [&](std::uint32_t node) { return node == 0 ? nodes - 1 : node - 1; };
  const float length = op.segment_length(load.at.node);
  const float from_node = (1 - static_cast<float>(load.at.weight)) * length;
  const float to_next = length - from_node;
  PositionSensitivity found{.radius = reach * length};
  const auto x = static_cast<float>(load.force_body.x());
  const auto y = static_cast<float>(load.force_body.y());
  float steepest = 0;
  float unit = 0;
  const auto include = [&](std::uint32_t node, float along) {
    const AxisForm form = slope_form(
        op, node, static_cast<double>(std::clamp(along / op.segment_length(node), 0.0f, 1.0f)));
    steepest = std::max(steepest, form.square(x, y));
    unit = std::max(unit, form.largest_eigenvalue());
  };
  include(load.at.node, from_node - found.radius);
  if (op.quadratic()) include(load.at.node, from_node + found.radius);
  const float near_node = 1.01f * found.radius;  // whatever the round-off of `from_corner`
  if (from_node <= near_node) {
    const std::uint32_t node = before(load.at.node);
    const float back = op.segment_length(node);
    include(node, back - (from_node + found.radius));
    if (op.quadratic() && load.at.node % 2 == 0) include(node, back);
  }
  if (to_next <= near_node) {
    include(load.at.next, to_next + found.radius);
    if (op.quadratic() && load.at.next % 2 == 0) include(load.at.next, 0);
  }
  found.force = std::sqrt(steepest);
  found.unit = std::sqrt(unit);
  found.holds_round_corner = std::abs(static_cast<float>(place.from_corner)) <= found.radius;
  return found;
}

// Of the derivatives by the arc length, at a part of the segment from a node.
RIPRAP_INLINE AxisForm WeightedInfluence::slope_form(const InfluenceOperatorF32& op,
                                                     std::uint32_t node, double along) const {
  const NodalShares side = op.shares({node, (node + 1) % op.locator().nodes(), 1});
  // Derivatives of the shares of its nodes.
  std::array<double, 3> slope{-1, 1, 0};
  if (op.quadratic() && node % 2 == 0) slope = {along - 1.5, 2 - 2 * along, along - 0.5};
  if (op.quadratic() && node % 2 != 0) slope = {-2 * along, along + 0.5, along - 0.5};
  const double per_length = 1 / static_cast<double>(op.segment_length(node));
  const FourFloats near = internal::four_times(slope[0] * per_length);
  const FourFloats far = internal::four_times(slope[1] * per_length);
  const FourFloats third = internal::four_times(slope[2] * per_length);
  const float* const a = op.columns(side.nodes[0]);
  const float* const b = op.columns(side.nodes[1]);
  const float* const c = op.columns(side.nodes[side.count - 1]);
  FourFloats xx{0, 0, 0, 0};
  FourFloats xy = xx;
  FourFloats yy = xx;
  for (std::size_t i = 0; i < size_; i += 4) {
    const auto factor = load_lanes<FourFloats>(factors_.data() + i);
    const std::size_t j = size_ + i;
    const FourFloats x =
        factor * (near * load_lanes<FourFloats>(a + i) + far * load_lanes<FourFloats>(b + i) +
                  third * load_lanes<FourFloats>(c + i));
    const FourFloats y =
        factor * (near * load_lanes<FourFloats>(a + j) + far * load_lanes<FourFloats>(b + j) +
                  third * load_lanes<FourFloats>(c + j));
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  // Round-off of the columns themselves is 6e-8 of them, and nodes are not near each other.
  const float off = 1e-4f * (lane_sum(xx) + lane_sum(yy));
  return {lane_sum(xx) + off, lane_sum(xy), lane_sum(xy), lane_sum(yy) + off};
}

}  // namespace riprap
