// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <numeric>

#include <riprap/core/simd.hpp>
#include <riprap/stress/banded_stiffness.hpp>

namespace riprap {

namespace internal {

/// Nodes in the order in which they lie along the particle: from one end to the node farthest from
/// the centroid, the origin.
[[nodiscard]] RIPRAP_INLINE std::vector<std::uint32_t> nodes_along(const std::vector<Vec2>& nodes) {
  Vec2 along = nodes.front();
  for (const Vec2& x : nodes)
    if (x.squaredNorm() > along.squaredNorm()) along = x;
  std::vector<std::uint32_t> order(nodes.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return along.dot(nodes[i]) < along.dot(nodes[j]);
  });
  return order;
}

// to -= factor * from.
inline void subtract(double factor, const double* from, std::size_t count, double* to) {
  std::size_t i = 0;
  for (; i + native_lanes <= count; i += native_lanes)
    store_lanes(to + i,
                load_lanes<DoubleLanes>(to + i) - factor * load_lanes<DoubleLanes>(from + i));
  for (; i < count; ++i) to[i] -= factor * from[i];
}

}  // namespace internal

RIPRAP_INLINE BandedStiffness::BandedStiffness(const Mesh& mesh, std::size_t nodes_of_element)
    : place_(mesh.nodes.size()), first_(2 * mesh.nodes.size()), last_(2 * mesh.nodes.size()) {
  const std::vector<std::uint32_t> order = internal::nodes_along(mesh.nodes);
  for (std::uint32_t i = 0; i < order.size(); ++i) place_[order[i]] = i;
  for (std::size_t e = 0; e < mesh.size(); ++e) {
    std::uint32_t lowest = place_[mesh.node(e, 0)];
    std::uint32_t highest = lowest;
    for (std::size_t k = 1; k < nodes_of_element; ++k) {
      const std::uint32_t place = place_[mesh.node(e, k)];
      lowest = std::min(lowest, place);
      highest = std::max(highest, place);
    }
    std::size_t& last = last_[2 * std::size_t{lowest}];
    last = std::max(last, 2 * std::size_t{highest} + 1);
  }
  std::size_t last = 0;
  std::size_t count = 0;
  for (std::size_t j = 0; j < size(); ++j) {
    last_[j] = last = std::max({last, last_[j], j});
    first_[j] = count;
    count += last - j + 1;
  }
  values_.assign(count, 0);
}

RIPRAP_INLINE void BandedStiffness::hold(const Mesh& mesh) {
  double trace = 0;
  for (std::size_t j = 0; j < size(); ++j) trace += *column(j);
  const double stiff = trace / static_cast<double>(size());
  const auto end = [&](std::size_t place) {
    return static_cast<std::size_t>(std::find(place_.begin(), place_.end(), place) -
                                    place_.begin());
  };
  const Vec2 line = mesh.nodes[end(place_.size() - 1)] - mesh.nodes[end(0)];
  const Vec2 across = perpendicular(line) / line.norm();
  *column(0) += stiff;
  *column(1) += stiff;
  const std::size_t j = size() - 2;
  column(j)[0] += stiff * across.x() * across.x();
  column(j)[1] += stiff * across.x() * across.y();
  column(j + 1)[0] += stiff * across.y() * across.y();
}

RIPRAP_INLINE void BandedStiffness::factorise() {
  for (std::size_t j = 0; j < size(); ++j) {
    double* const eliminated = column(j);
    const std::size_t below = last_[j] - j;
    for (std::size_t k = 1; k <= below; ++k)
      internal::subtract(eliminated[k] / eliminated[0], eliminated + k, below - k + 1,
                         column(j + k));
    for (std::size_t k = 1; k <= below; ++k) eliminated[k] /= eliminated[0];
  }
}

RIPRAP_INLINE void BandedStiffness::solve(std::vector<double>& sides, std::size_t loads) const {
  const auto at = [&](std::size_t r) { return sides.data() + r * loads; };
  for (std::size_t j = 0; j < size(); ++j)
    for (std::size_t r = j + 1; r <= last_[j]; ++r)
      internal::subtract(column(j)[r - j], at(j), loads, at(r));
  for (std::size_t j = size(); j-- > 0;) {
    for (std::size_t c = 0; c < loads; ++c) at(j)[c] /= *column(j);
    for (std::size_t r = j + 1; r <= last_[j]; ++r)
      internal::subtract(column(j)[r - j], at(r), loads, at(j));
  }
}

}  // namespace riprap
