// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Stresses due to unit forces at the contact points of one particle, with the elements weighted.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <riprap/acceleration/screening/axis_form.hpp>
#include <riprap/acceleration/screening/influence_operator_f32.hpp>
#include <riprap/core/linkage.hpp>
#include <riprap/stress/boundary_load.hpp>
#include <riprap/stress/boundary_locator.hpp>

namespace riprap {

/// How fast the stresses change with the arc length of a load along the boundary.
struct PositionSensitivity {
  float force = 0;   ///< under the force of the load [N/m^3]
  float unit = 0;    ///< under a unit force along any axis [1/m^3]
  float radius = 0;  ///< arc length from the load within which both hold, along its edge [m]
  /// And round a corner next to the load, as far from it as the load is, and the radius.
  bool holds_round_corner = false;
};

/// The stresses of every element are multiplied by a factor of it. The norm of all is then a
/// quadratic form in the forces at the points. Single precision.
class WeightedInfluence {
 public:
  /// Of each product of two columns over that of their norms, at most: the round-off of sums of
  /// three terms for each sampling point, 1,200 with 100 triangles of six nodes. Measured: 6e-7
  /// with 1,600 points.
  static constexpr double product_error = 4e-5;

  /// Of unit forces at the points of `loads`, which are on the boundary.
  /// @param places of the loads: their corners
  /// @param factors of the elements, and zeros up to whole vectors of those of the operator
  void assign(const InfluenceOperatorF32& op, std::span<const BoundaryLoad> loads,
              std::span<const LocatedPoint> places, std::span<const float> factors);

  /// For unit forces at the points of loads c and d: the sum over all elements of the products of
  /// their weighted stresses, the shear counted twice, as a matrix of the axes of the forces. Off
  /// by at most `product_error` times the norms of the two.
  [[nodiscard]] AxisForm product(std::size_t c, std::size_t d) const;

  /// Of load c. The norm of the change of the weighted stresses is at most that times the arc
  /// length by which its point moves.
  [[nodiscard]] const PositionSensitivity& position_sensitivity(std::size_t c) const {
    return sensitivities_[c];
  }
  /// Upper bound on the norm of the weighted stresses due to a unit force anywhere [1/m^2].
  [[nodiscard]] double largest_norm() const { return largest_norm_; }
  /// That of the operator.
  [[nodiscard]] double shape_factor() const { return shape_factor_; }

 private:
  // Part of the spacing of nodes by which a point may move: the less, the fewer segments it
  // reaches.
  static constexpr float reach = 0.25f;

  [[nodiscard]] const float* columns(std::size_t c) const {
    return columns_.data() + c * 2 * size_;
  }
  void weight_columns(const InfluenceOperatorF32& op, const BoundaryPoint& point, float* to) const;
  [[nodiscard]] PositionSensitivity find_sensitivity(const InfluenceOperatorF32& op,
                                                     const BoundaryLoad& load,
                                                     const LocatedPoint& place) const;
  [[nodiscard]] AxisForm slope_form(const InfluenceOperatorF32& op, std::uint32_t node,
                                    double along) const;

  std::size_t size_ = 0;        // of a column
  std::vector<float> factors_;  // of a column: the shear's times the root of two
  std::vector<float> columns_;  // two of each load
  std::vector<PositionSensitivity> sensitivities_;
  double largest_norm_ = 0;
  double shape_factor_ = 1;
};

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/acceleration/screening/weighted_influence.ipp>
#endif
