#pragma once
/// @file
/// The influence operator in single precision, with a bound on its error: what tells particles that
/// may break from those that cannot.

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <riprap/stress/boundary_load.hpp>
#include <riprap/stress/influence_operator.hpp>
#include <riprap/stress/outline.hpp>

namespace riprap {

/// Stresses [Pa] of all elements as a CompactOperator gives them. Every component is within `error`
/// of what the InfluenceOperator gives.
struct CompactStress {
  Eigen::ArrayXf values;  ///< the s11 of every element, then the s22, then the s12, each padded
  Eigen::Index elements = 0;
  Eigen::Index stride = 0;  ///< from one component to the next
  double error = 0;

  [[nodiscard]] auto component(Eigen::Index c) const {
    return values.segment(c * stride, elements);
  }
};

/// Half the memory of the InfluenceOperator it is made from, and no mesh: a pass over it is limited
/// by memory and takes half the time. Nothing that reaches a result is computed with it.
class CompactOperator {
 public:
  CompactOperator() = default;
  explicit CompactOperator(const InfluenceOperator& op)
      : outline_(op.mesh()), elements_(static_cast<Eigen::Index>(op.mesh().size())),
        stride_((elements_ + pad - 1) / pad * pad) {
    const Eigen::MatrixXd& exact = op.columns();
    columns_.setZero(3 * stride_, exact.cols());
    for (Eigen::Index c = 0; c < 3; ++c)
      columns_.middleRows(c * stride_, elements_) =
          exact.middleRows(c * elements_, elements_).cast<float>();
    const auto count = static_cast<std::size_t>(outline_.nodes());
    largest_.resize(count);
    for (std::size_t j = 0; j < count; ++j)
      largest_[j] = columns_.middleCols<2>(2 * static_cast<Eigen::Index>(j)).cwiseAbs().maxCoeff();
    sum_products();
    find_steepness(op.mesh());
  }

  [[nodiscard]] bool empty() const { return elements_ == 0; }
  [[nodiscard]] std::size_t elements() const { return static_cast<std::size_t>(elements_); }
  [[nodiscard]] const Outline& outline() const { return outline_; }

  /// Stresses under `scale` times the loads.
  void find_stress(std::span<const BoundaryLoad> loads, double scale, CompactStress& out) const {
    out.elements = elements_;
    out.stride = stride_;
    out.values.setZero(3 * stride_);
    double terms = 0;
    for (const BoundaryLoad& load : loads) {
      const Vec2 near = scale * load.at.weight * load.force;
      const Vec2 far = scale * (1 - load.at.weight) * load.force;
      const auto j = static_cast<Eigen::Index>(load.at.node);
      const auto k = static_cast<Eigen::Index>(load.at.next);
      out.values.matrix().noalias() += static_cast<float>(near.x()) * columns_.col(2 * j) +
                                       static_cast<float>(near.y()) * columns_.col(2 * j + 1) +
                                       static_cast<float>(far.x()) * columns_.col(2 * k) +
                                       static_cast<float>(far.y()) * columns_.col(2 * k + 1);
      terms += near.lpNorm<1>() * largest_[load.at.node] + far.lpNorm<1>() * largest_[load.at.next];
    }
    // Of every term two roundings to single precision and one product, then the sum: half a unit in
    // the last place each, of at most the sum of the absolute terms. Twice that is allowed for.
    out.error = terms * static_cast<double>(4 * loads.size() + 4) * 0x1p-23;
  }

  /// Sum over all elements of the product of two columns' stresses, the shear counted twice: with
  /// it the Frobenius norm of all stresses under nodal forces is a quadratic form. Off by at most
  /// `product_error` times the norms of the two.
  [[nodiscard]] double product(Eigen::Index p, Eigen::Index q) const {
    if (p > q) std::swap(p, q);
    return products_[static_cast<std::size_t>(q * (q + 1) / 2 + p)];
  }
  /// Sums of some 300 terms in single precision, at half a unit in the last place each.
  static constexpr double product_error = 4e-5;
  /// The same for unit forces at two boundary points, as a matrix of the axes of the forces.
  [[nodiscard]] Eigen::Matrix2d product(const BoundaryPoint& a, const BoundaryPoint& b) const {
    return a.weight * (b.weight * block(a.node, b.node) + (1 - b.weight) * block(a.node, b.next)) +
           (1 - a.weight) *
               (b.weight * block(a.next, b.node) + (1 - b.weight) * block(a.next, b.next));
  }

  /// Largest Frobenius norm of the stresses due to a unit force anywhere on the boundary [1/m^2].
  [[nodiscard]] double largest_norm() const { return largest_norm_; }
  /// How far a place may move from `at` for `steepness` to hold [m]: one node spacing.
  [[nodiscard]] double reach(const BoundaryPoint& at) const { return spacing_[at.node]; }
  /// Largest change of the stresses due to a unit force, in the Frobenius norm, over the distance
  /// by which it moves along the boundary near `at` [1/m^3].
  [[nodiscard]] double steepness(const BoundaryPoint& at) const {
    const std::uint32_t nodes = outline_.nodes();
    return std::max(
        {steepness_[(at.node + nodes - 1) % nodes], steepness_[at.node], steepness_[at.next]});
  }

  [[nodiscard]] std::size_t bytes() const {
    return sizeof(float) * (static_cast<std::size_t>(columns_.size()) + products_.size() +
                            3 * largest_.size()) +
           outline_.bytes();
  }

 private:
  static constexpr Eigen::Index pad = 8;  // elements, for whole vectors of single precision

  [[nodiscard]] Eigen::Matrix2d block(std::uint32_t i, std::uint32_t j) const {
    const auto p = 2 * static_cast<Eigen::Index>(i);
    const auto q = 2 * static_cast<Eigen::Index>(j);
    Eigen::Matrix2d b;
    b << product(p, q), product(p, q + 1), product(p + 1, q), product(p + 1, q + 1);
    return b;
  }

  void sum_products() {
    const Eigen::Index n = columns_.cols();
    products_.reserve(static_cast<std::size_t>(n * (n + 1) / 2));
    Eigen::VectorXf weighted;
    for (Eigen::Index q = 0; q < n; ++q) {
      weighted = columns_.col(q);
      weighted.tail(stride_) *= 2;
      for (Eigen::Index p = 0; p <= q; ++p) products_.push_back(columns_.col(p).dot(weighted));
    }
  }

  // Largest eigenvalue of a symmetric, non-negative matrix.
  [[nodiscard]] static double largest_eigenvalue(const Eigen::Matrix2d& m) {
    const double half = 0.5 * (m(0, 0) - m(1, 1));
    const double off = 0.5 * (m(0, 1) + m(1, 0));
    return 0.5 * (m(0, 0) + m(1, 1)) + std::sqrt(half * half + off * off);
  }

  void find_steepness(const Mesh& mesh) {
    const std::uint32_t nodes = outline_.nodes();
    for (std::uint32_t j = 0; j < nodes; ++j) {
      const std::uint32_t k = (j + 1) % nodes;
      const double own = largest_eigenvalue(block(j, j));
      largest_norm_ = std::max(largest_norm_, std::sqrt(own));
      const Eigen::Matrix2d change = block(j, j) + block(k, k) - block(j, k) - block(k, j);
      // Four products in a difference, two axes in an eigenvalue.
      const double off = 4 * product_error * (own + largest_eigenvalue(block(k, k)));
      const double length = (mesh.nodes[k] - mesh.nodes[j]).norm();
      spacing_.push_back(static_cast<float>(length));
      steepness_.push_back(
          static_cast<float>(std::sqrt(largest_eigenvalue(change) + off) / length));
    }
  }

  Outline outline_;
  Eigen::Index elements_ = 0;
  Eigen::Index stride_ = 0;
  Eigen::MatrixXf columns_;
  std::vector<float> products_;   // upper triangle, column by column
  std::vector<float> largest_;    // component of the two columns of a node
  std::vector<float> steepness_;  // of the piece of boundary from a node to the next
  std::vector<float> spacing_;    // its length
  double largest_norm_ = 0;
};

}  // namespace riprap
