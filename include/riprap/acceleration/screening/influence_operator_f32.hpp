// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The influence operator (influence matrix) in single precision with an error bound, for
/// screening.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <riprap/core/linkage.hpp>
#include <riprap/stress/boundary_load.hpp>
#include <riprap/stress/boundary_locator.hpp>
#include <riprap/stress/influence_operator.hpp>
#include <riprap/stress/nodal_shares.hpp>

namespace riprap {

/// Stresses [Pa] of all elements, at their sampling points, in single precision. Every component is
/// within `error` of the result of the InfluenceOperator.
struct ElementStressF32 {
  std::vector<float> values;  ///< the s11 of every element, then the s22, then the s12, each padded
  std::size_t elements = 0;   ///< sampling points
  std::size_t stride = 0;     ///< from one component to the next
  double error = 0;

  [[nodiscard]] std::span<const float> component(std::size_t c) const {
    return {values.data() + c * stride, elements};
  }
};

/// Half the size of the InfluenceOperator it is made from, without the mesh: its use is limited by
/// memory bandwidth. No result is computed with it; it only screens particles.
class InfluenceOperatorF32 {
 public:
  InfluenceOperatorF32() = default;
  explicit InfluenceOperatorF32(const InfluenceOperator& op);

  /// Number of sampling points.
  [[nodiscard]] std::size_t elements() const { return elements_; }
  /// area_weights of the sampling points.
  [[nodiscard]] std::span<const float> area_weights() const { return area_weights_; }
  [[nodiscard]] const BoundaryLocator& locator() const { return locator_; }

  /// Stresses under `scale` times the loads. Throws InvalidInput for a load that is not on the
  /// boundary or not finite.
  void find_stress(std::span<const BoundaryLoad> loads, double scale, ElementStressF32& out) const;

  /// The sum of the absolute shares of a force at the nodes of its side, and that of their slopes,
  /// are at most so many times those of linear shape functions, which are 1 and 2 per node spacing.
  [[nodiscard]] double shape_factor() const { return quadratic_ ? 2 : 1; }

  /// Largest Frobenius norm of the stresses due to a unit force anywhere on the boundary [1/m^2].
  [[nodiscard]] double largest_norm() const { return largest_norm_; }
  /// Length of the boundary from `node` to the next [m].
  [[nodiscard]] float segment_length(std::uint32_t node) const { return lengths_[node]; }
  /// Whether every second boundary node is a mid-side node.
  [[nodiscard]] bool quadratic() const { return quadratic_; }
  [[nodiscard]] NodalShares shares(const BoundaryPoint& at) const {
    return nodal_shares(at, quadratic_, locator_.nodes());
  }
  /// The `padded_size()` stresses due to a unit force along x at a node, laid out like those of
  /// ElementStressF32; behind them those of a unit force along y.
  [[nodiscard]] const float* columns(std::uint32_t node) const {
    return columns_.data() + std::size_t{node} * 2 * padded_size();
  }
  [[nodiscard]] std::size_t padded_size() const { return 3 * stride_; }

  [[nodiscard]] std::size_t bytes() const {
    return sizeof(float) * (columns_.size() + largest_.size() + lengths_.size()) +
           sizeof(float) * area_weights_.size() + locator_.bytes();
  }

 private:
  static constexpr std::size_t pad = 8;  // elements, for whole vectors of single precision

  void find_largest_norm();

  BoundaryLocator locator_;
  bool quadratic_ = false;  // shape functions of the sides
  std::size_t elements_ = 0;
  std::size_t stride_ = 0;
  std::vector<float> area_weights_;
  std::vector<float> columns_;  // of the components of ElementStressF32
  std::vector<float> largest_;  // component of the two columns of a node
  std::vector<float> lengths_;  // of the boundary from each node to the next
  double largest_norm_ = 0;
};

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/acceleration/screening/influence_operator_f32.ipp>
#endif
