// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The influence operator (influence matrix) in single precision with an error bound, for
/// screening.

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include <riprap/stress/boundary_load.hpp>
#include <riprap/stress/boundary_locator.hpp>
#include <riprap/stress/influence_operator.hpp>

namespace riprap {

/// Stresses [Pa] of all elements in single precision. Every component is within `error` of the
/// result of the InfluenceOperator.
struct ElementStressF32 {
  Eigen::ArrayXf values;  ///< the s11 of every element, then the s22, then the s12, each padded
  Eigen::Index elements = 0;
  Eigen::Index stride = 0;  ///< from one component to the next
  double error = 0;

  [[nodiscard]] auto component(Eigen::Index c) const {
    return values.segment(c * stride, elements);
  }
};

/// Half the size of the InfluenceOperator it is made from, without the mesh: its use is limited by
/// memory bandwidth. No result is computed with it; it only screens particles.
class InfluenceOperatorF32 {
 public:
  InfluenceOperatorF32() = default;
  explicit InfluenceOperatorF32(const InfluenceOperator& op)
      : locator_(op.mesh()), elements_(static_cast<Eigen::Index>(op.mesh().size())),
        stride_((elements_ + pad - 1) / pad * pad) {
    const Eigen::MatrixXd& exact = op.columns();
    columns_.setZero(3 * stride_, exact.cols());
    for (Eigen::Index c = 0; c < 3; ++c)
      columns_.middleRows(c * stride_, elements_) =
          exact.middleRows(c * elements_, elements_).cast<float>();
    const auto count = static_cast<std::size_t>(locator_.nodes());
    largest_.resize(count);
    for (std::size_t j = 0; j < count; ++j)
      largest_[j] = columns_.middleCols<2>(2 * static_cast<Eigen::Index>(j)).cwiseAbs().maxCoeff();
    sum_products();
    find_position_sensitivity(op.mesh());
  }

  [[nodiscard]] std::size_t elements() const { return static_cast<std::size_t>(elements_); }
  [[nodiscard]] const BoundaryLocator& locator() const { return locator_; }

  /// Stresses under `scale` times the loads. Throws InvalidInput for a load that is not on the
  /// boundary or not finite.
  void find_stress(std::span<const BoundaryLoad> loads, double scale, ElementStressF32& out) const {
    out.elements = elements_;
    out.stride = stride_;
    out.values.setZero(3 * stride_);
    double terms = 0;
    for (const BoundaryLoad& load : loads) {
      require_boundary_load(load.at, load.force, locator_.nodes());
      const Vec2 near = scale * load.at.weight * load.force;
      const Vec2 far = scale * (1 - load.at.weight) * load.force;
      const auto j = static_cast<Eigen::Index>(load.at.node);
      const auto k = static_cast<Eigen::Index>(load.at.next);
      out.values.matrix().noalias() += static_cast<float>(near.x()) * columns_.col(2 * j) +
                                       static_cast<float>(near.y()) * columns_.col(2 * j + 1) +
                                       static_cast<float>(far.x()) * columns_.col(2 * k) +
                                       static_cast<float>(far.y()) * columns_.col(2 * k + 1);
      terms += near.lpNorm<1>() * static_cast<double>(largest_[load.at.node]) +
               far.lpNorm<1>() * static_cast<double>(largest_[load.at.next]);
    }
    // Two roundings to single precision and one product per term, then the sum: half a unit in the
    // last place each, of at most the sum of the absolute terms. Twice that is assumed. No bound is
    // given for units beyond the range of single precision.
    const bool in_range = largest_norm_ > 1e-12 && largest_norm_ < 1e12;
    out.error = in_range ? terms * static_cast<double>(4 * loads.size() + 4) * 0x1p-23
                         : std::numeric_limits<double>::infinity();
  }

  /// For unit forces at two boundary points: the sum over all elements of the products of their
  /// stresses, the shear counted twice, as a matrix of the axes of the forces. With it the square
  /// of the Frobenius norm of all stresses is a quadratic form. Off by at most `product_error`
  /// times the norms of the two: sums of some 300 terms in single precision.
  static constexpr double product_error = 4e-5;
  [[nodiscard]] Eigen::Matrix2f product(const BoundaryPoint& a, const BoundaryPoint& b) const {
    const auto w = static_cast<float>(a.weight);
    const auto v = static_cast<float>(b.weight);
    const std::array<Eigen::Matrix2f, 4> blocks{block(a.node, b.node), block(a.node, b.next),
                                                block(a.next, b.node), block(a.next, b.next)};
    const std::array<float, 4> weights{w * v, w * (1 - v), (1 - w) * v, (1 - w) * (1 - v)};
    // A loop: as an Eigen expression it would compile 400 functions.
    Eigen::Matrix2f sums;
    for (Eigen::Index k = 0; k < 4; ++k)
      sums(k) = weights[0] * blocks[0](k) + weights[1] * blocks[1](k) + weights[2] * blocks[2](k) +
                weights[3] * blocks[3](k);
    return sums;
  }

  /// Largest Frobenius norm of the stresses due to a unit force anywhere on the boundary [1/m^2].
  [[nodiscard]] double largest_norm() const { return largest_norm_; }
  /// Distance from `at` along its edge within which `position_sensitivity` is valid [m]: one node
  /// spacing.
  [[nodiscard]] double valid_radius(const BoundaryPoint& at) const {
    return static_cast<double>(segments_[at.node].length);
  }
  /// Upper bound on the Frobenius norm of the change of the stresses due to `force` [N], per unit
  /// of arc length by which its point moves near `at` [N/m^3].
  [[nodiscard]] double position_sensitivity(const BoundaryPoint& at, const Vec2& force) const {
    const std::uint32_t nodes = locator_.nodes();
    const auto x = static_cast<float>(force.x());
    const auto y = static_cast<float>(force.y());
    float largest = 0;
    for (const std::uint32_t node : {(at.node + nodes - 1) % nodes, at.node, at.next}) {
      const Segment& segment = segments_[node];
      largest = std::max(largest, x * (x * segment.xx + y * segment.xy) + y * y * segment.yy);
    }
    return std::sqrt(static_cast<double>(largest));
  }
  /// The same for a unit force along any axis [1/m^3].
  [[nodiscard]] double position_sensitivity(const BoundaryPoint& at) const {
    const std::uint32_t nodes = locator_.nodes();
    const float steepest = std::max({segments_[(at.node + nodes - 1) % nodes].position_sensitivity,
                                     segments_[at.node].position_sensitivity,
                                     segments_[at.next].position_sensitivity});
    return static_cast<double>(steepest);
  }

  [[nodiscard]] std::size_t bytes() const {
    return sizeof(float) * (static_cast<std::size_t>(columns_.size()) + 4 * products_.size() +
                            largest_.size()) +
           sizeof(Segment) * segments_.size() + locator_.bytes();
  }

 private:
  static constexpr Eigen::Index pad = 8;  // elements, for whole vectors of single precision

  [[nodiscard]] Eigen::Matrix2f block(std::uint32_t i, std::uint32_t j) const {
    const auto stored = [this](std::uint32_t row, std::uint32_t column) -> const Eigen::Matrix2f& {
      return products_[row * (row + 1) / 2 + column];
    };
    if (i >= j) return stored(i, j);
    const Eigen::Matrix2f& mirrored = stored(j, i);
    return Eigen::Matrix2f{{mirrored(0, 0), mirrored(1, 0)}, {mirrored(0, 1), mirrored(1, 1)}};
  }

  void sum_products() {
    const auto nodes = static_cast<Eigen::Index>(locator_.nodes());
    Eigen::MatrixXf weighted;
    for (Eigen::Index i = 0; i < nodes; ++i) {
      weighted = columns_.middleCols<2>(2 * i);
      weighted.bottomRows(stride_) *= 2;
      for (Eigen::Index j = 0; j <= i; ++j) {
        Eigen::Matrix2f& sums = products_.emplace_back();
        for (Eigen::Index p = 0; p < 2; ++p)
          for (Eigen::Index q = 0; q < 2; ++q)
            sums(p, q) = weighted.col(p).dot(columns_.col(2 * j + q));
      }
    }
  }

  // Largest eigenvalue of a symmetric, non-negative matrix.
  [[nodiscard]] static double largest_eigenvalue(const Eigen::Matrix2f& single) {
    const auto m = [&](Eigen::Index p, Eigen::Index q) {
      return static_cast<double>(single(p, q));
    };
    const double half = 0.5 * (m(0, 0) - m(1, 1));
    const double off = 0.5 * (m(0, 1) + m(1, 0));
    return 0.5 * (m(0, 0) + m(1, 1)) + std::sqrt(half * half + off * off);
  }

  void find_position_sensitivity(const Mesh& mesh) {
    const std::uint32_t nodes = locator_.nodes();
    for (std::uint32_t j = 0; j < nodes; ++j) {
      const std::uint32_t k = (j + 1) % nodes;
      largest_norm_ = std::max(largest_norm_, std::sqrt(largest_eigenvalue(block(j, j))));
      Eigen::MatrixXf change = columns_.middleCols<2>(2 * static_cast<Eigen::Index>(j)) -
                               columns_.middleCols<2>(2 * static_cast<Eigen::Index>(k));
      change.bottomRows(stride_) *= std::numbers::sqrt2_v<float>;
      const double length = (mesh.nodes[k] - mesh.nodes[j]).norm();
      const auto per_square = static_cast<float>(1 / (length * length));
      Eigen::Matrix2f form;
      form(0, 0) = change.col(0).dot(change.col(0));
      form(0, 1) = form(1, 0) = change.col(0).dot(change.col(1));
      form(1, 1) = change.col(1).dot(change.col(1));
      form *= per_square;
      // Round-off of the columns themselves is 6e-8 of them, and nodes are not near each other.
      const float off = 1e-4f * form.trace();
      segments_.push_back(
          {form(0, 0) + off, 2 * form(0, 1), form(1, 1) + off,
           static_cast<float>(std::sqrt(largest_eigenvalue(form) + static_cast<double>(off))),
           static_cast<float>(length)});
    }
  }

  // Of boundary, from a node to the next: with the quadratic form of the squared sensitivity.
  struct Segment {
    float xx, xy, yy;
    float position_sensitivity;
    float length;
  };

  BoundaryLocator locator_;
  Eigen::Index elements_ = 0;
  Eigen::Index stride_ = 0;
  Eigen::MatrixXf columns_;
  std::vector<Eigen::Matrix2f> products_;  // of two nodes each, the lower triangle row by row
  std::vector<float> largest_;             // component of the two columns of a node
  std::vector<Segment> segments_;
  double largest_norm_ = 0;
};

}  // namespace riprap
