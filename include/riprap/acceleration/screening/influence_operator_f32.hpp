// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The influence operator (influence matrix) in single precision with an error bound, for
/// screening.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <riprap/core/linkage.hpp>
#include <riprap/stress/boundary_load.hpp>
#include <riprap/stress/boundary_locator.hpp>
#include <riprap/stress/influence_operator.hpp>
#include <riprap/stress/largest_areas.hpp>
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

/// A bilinear form of the axes of two forces, in single precision.
struct AxisForm {
  float xx = 0;
  float xy = 0;  ///< of the x of the first force and the y of the second
  float yx = 0;
  float yy = 0;
};

/// Half the size of the InfluenceOperator it is made from, without the mesh: its use is limited by
/// memory bandwidth. No result is computed with it; it only screens particles.
class InfluenceOperatorF32 {
 public:
  InfluenceOperatorF32() = default;
  explicit InfluenceOperatorF32(const InfluenceOperator& op);

  /// Number of sampling points.
  [[nodiscard]] std::size_t elements() const { return elements_; }
  [[nodiscard]] const LargestAreas& areas() const { return areas_; }
  [[nodiscard]] const BoundaryLocator& locator() const { return locator_; }

  /// Stresses under `scale` times the loads. Throws InvalidInput for a load that is not on the
  /// boundary or not finite.
  void find_stress(std::span<const BoundaryLoad> loads, double scale, ElementStressF32& out) const;

  /// For unit forces at two boundary points: the sum over all elements of the products of their
  /// stresses, the shear counted twice, as a matrix of the axes of the forces. With it the square
  /// of the Frobenius norm of all stresses is a quadratic form. Off by at most `product_error`
  /// times the norms of the two: sums of three terms for each sampling point in single precision,
  /// 1,200 with 100 triangles of six nodes. Measured: 6e-7 with 1,600 points.
  static constexpr double product_error = 4e-5;
  [[nodiscard]] AxisForm product(const BoundaryPoint& a, const BoundaryPoint& b) const;

  /// The sum of the absolute shares of a force at the nodes of its side, and that of their slopes,
  /// are at most so many times those of linear shape functions, which are 1 and 2 per node spacing.
  [[nodiscard]] double shape_factor() const { return quadratic_ ? 2 : 1; }

  /// Largest Frobenius norm of the stresses due to a unit force anywhere on the boundary [1/m^2].
  [[nodiscard]] double largest_norm() const { return largest_norm_; }
  /// Distance from `at` along its edge within which `position_sensitivity` is valid [m]: one node
  /// spacing.
  [[nodiscard]] double valid_radius(const BoundaryPoint& at) const {
    return static_cast<double>(segments_[at.node * ends()].length);
  }
  /// Upper bound on the Frobenius norm of the change of the stresses due to `force` [N], per unit
  /// of arc length by which its point moves near `at` [N/m^3].
  [[nodiscard]] double position_sensitivity(const BoundaryPoint& at, const Vec2& force) const;
  /// The same for a unit force along any axis [1/m^3].
  [[nodiscard]] double position_sensitivity(const BoundaryPoint& at) const;

  [[nodiscard]] std::size_t bytes() const {
    return sizeof(float) * (columns_.size() + 4 * products_.size() + largest_.size()) +
           sizeof(Segment) * segments_.size() + areas_.bytes() + locator_.bytes();
  }

 private:
  static constexpr std::size_t pad = 8;  // elements, for whole vectors of single precision

  [[nodiscard]] const float* column(std::size_t j) const {
    return columns_.data() + j * 3 * stride_;
  }
  [[nodiscard]] AxisForm quadratic_product(const BoundaryPoint& a, const BoundaryPoint& b) const;
  [[nodiscard]] AxisForm block(std::uint32_t i, std::uint32_t j) const;
  [[nodiscard]] float stress_product(const float* a, const float* b) const;
  void sum_products();
  void find_position_sensitivity(const Mesh& mesh);
  [[nodiscard]] std::array<float, 3> slopes(std::uint32_t node, std::uint32_t end) const;
  // Ends of a segment at which the sensitivity differs: the derivative of the stresses is constant
  // along it, or linear, so that its norm is the largest at an end.
  [[nodiscard]] std::uint32_t ends() const { return quadratic_ ? 2 : 1; }
  [[nodiscard]] NodalShares shares(const BoundaryPoint& at) const {
    return nodal_shares(at, quadratic_, locator_.nodes());
  }

  // Of boundary, from a node to the next: with the quadratic form of the squared sensitivity.
  struct Segment {
    float xx, xy, yy;
    float position_sensitivity;
    float length;
  };

  BoundaryLocator locator_;
  bool quadratic_ = false;  // shape functions of the sides
  std::size_t elements_ = 0;
  std::size_t stride_ = 0;
  LargestAreas areas_;
  std::vector<float> columns_;      // of the components of ElementStressF32
  std::vector<AxisForm> products_;  // of two nodes each, the lower triangle row by row
  std::vector<float> largest_;      // component of the two columns of a node
  std::vector<Segment> segments_;   // one for each of the ends
  double largest_norm_ = 0;
};

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/acceleration/screening/influence_operator_f32.ipp>
#endif
