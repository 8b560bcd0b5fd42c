// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Element stresses as a linear function of boundary forces, computed once per particle shape.

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <array>
#include <cmath>
#include <utility>

#include <riprap/core/errors.hpp>
#include <riprap/material/rock.hpp>
#include <riprap/stress/boundary_load.hpp>
#include <riprap/stress/element/concepts.hpp>
#include <riprap/stress/element_stress.hpp>
#include <riprap/stress/mesh/mesh.hpp>
#include <riprap/stress/plane_state/concepts.hpp>

namespace riprap {

/// stress = S f. The mesh never changes in the particle's own frame, so neither does S: checking a
/// particle costs one pass over four columns of S per contact instead of assembling and solving.
///
/// The particle is free: a net force and moment are balanced by its inertia (inertia relief), and
/// rigid modes carry no stress. Stress does not depend on Young's modulus.
class InfluenceOperator {
 public:
  InfluenceOperator() = default;

  /// @param mesh      in the body's own frame, centroid at the origin
  /// @param thickness out of plane [m]
  /// @param with_flexibility also keep the displacements of the boundary (for pinned supports)
  /// Throws InvalidInput for a mesh, a rock or a thickness that breaks a rule, and for an element
  /// or a plane state whose matrices are not finite.
  template <Element E, PlaneState P>
  InfluenceOperator(Mesh mesh, const E& element, const P& plane, const Rock& rock, double thickness,
                    bool with_flexibility)
      : mesh_(std::move(mesh)) {
    mesh_.validate();
    rock.validate();
    require_positive("InfluenceOperator: thickness", thickness);
    const Eigen::Matrix3d elasticity = plane.elasticity(rock);
    const Eigen::MatrixXd displacement = solve(element, elasticity, thickness);
    const auto elements = static_cast<Eigen::Index>(mesh_.size());
    stress_.resize(3 * elements, displacement.cols());
    for (std::size_t e = 0; e < mesh_.size(); ++e) {
      // The one place where tension-positive algebra becomes compression-positive stress.
      const StrainDisplacement to_stress =
          -(elasticity * element.strain_displacement(mesh_.triangle(e)));
      Eigen::Matrix<double, 6, Eigen::Dynamic> nodal(6, displacement.cols());
      for (int k = 0; k < 3; ++k)
        nodal.middleRows<2>(2 * k) = displacement.middleRows<2>(
            2 * static_cast<Eigen::Index>(mesh_.triangles[e][static_cast<std::size_t>(k)]));
      const Eigen::Matrix<double, 3, Eigen::Dynamic> rows = to_stress.lazyProduct(nodal);
      for (int c = 0; c < 3; ++c)
        stress_.row(c * elements + static_cast<Eigen::Index>(e)) = rows.row(c);
    }
    require(std::isfinite(stress_.sum()), "InfluenceOperator: sum of the stresses of unit loads",
            stress_.sum(), "must be finite (element, plane state)");
    if (with_flexibility) flexibility_ = displacement.topRows(displacement.cols());
  }

  [[nodiscard]] const Mesh& mesh() const { return mesh_; }
  [[nodiscard]] bool empty() const { return stress_.size() == 0; }
  /// S [1/m^2]: a column for each boundary node and axis, with the s11 of every element, then the
  /// s22, then the s12.
  [[nodiscard]] const Eigen::MatrixXd& columns() const { return stress_; }

  /// Adds the stresses due to a force [N] at a boundary point. Throws InvalidInput for a point that
  /// is not on the boundary and a force that is not finite.
  void add_stress(const BoundaryPoint& at, const Vec2& force, ElementStress& stress) const {
    require_boundary_load(at, force, mesh_.boundary_nodes);
    const double w = at.weight;
    stress.values().noalias() += (w * force.x()) * stress_.col(column(at.node)) +
                                 (w * force.y()) * stress_.col(column(at.node) + 1) +
                                 ((1 - w) * force.x()) * stress_.col(column(at.next)) +
                                 ((1 - w) * force.y()) * stress_.col(column(at.next) + 1);
  }

  /// Displacement [m] of one boundary point under a force [N] at another, up to a rigid motion that
  /// is the same for all points. Needs the flexibility.
  [[nodiscard]] Vec2 displacement(const BoundaryPoint& of, const BoundaryPoint& at,
                                  const Vec2& force) const {
    const auto block = [&](std::uint32_t i, std::uint32_t j) -> Vec2 {
      return flexibility_.block<2, 2>(column(i), column(j)) * force;
    };
    return of.weight *
               (at.weight * block(of.node, at.node) + (1 - at.weight) * block(of.node, at.next)) +
           (1 - of.weight) *
               (at.weight * block(of.next, at.node) + (1 - at.weight) * block(of.next, at.next));
  }

  [[nodiscard]] std::size_t bytes() const {
    return sizeof(double) * static_cast<std::size_t>(stress_.size() + flexibility_.size());
  }

 private:
  [[nodiscard]] static Eigen::Index column(std::uint32_t node) {
    return 2 * static_cast<Eigen::Index>(node);
  }

  // Displacements of all nodes for a unit force at each boundary node along each axis.
  template <class E>
  [[nodiscard]] Eigen::MatrixXd solve(const E& element, const Eigen::Matrix3d& elasticity,
                                      double thickness) const {
    const auto n = static_cast<Eigen::Index>(mesh_.nodes.size());
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(n, n);
    for (std::size_t e = 0; e < mesh_.size(); ++e) {
      const auto corners = mesh_.triangle(e);
      add_stiffness(e, element.strain_displacement(corners), elasticity, thickness, stiffness);
      const Eigen::Matrix3d m = element.mass(corners);
      for (int p = 0; p < 3; ++p)
        for (int q = 0; q < 3; ++q) mass(node(e, p), node(e, q)) += m(p, q);
    }
    return solve(std::move(stiffness), mass);
  }

  [[nodiscard]] Eigen::Index node(std::size_t element, int corner) const {
    return mesh_.triangles[element][static_cast<std::size_t>(corner)];
  }

  // Plain loops, here and below, where sums are short: the classes that Eigen makes of every such
  // expression took compilers longer than the loops do.
  void add_stiffness(std::size_t e, const StrainDisplacement& b, const Eigen::Matrix3d& elasticity,
                     double thickness, Eigen::MatrixXd& stiffness) const {
    const double volume = thickness * mesh_.area(e);
    for (int p = 0; p < 6; ++p) {
      std::array<double, 3> stress{};
      for (int j = 0; j < 3; ++j)
        for (int k = 0; k < 3; ++k)
          stress[static_cast<std::size_t>(j)] += volume * b(k, p) * elasticity(k, j);
      for (int q = 0; q < 6; ++q) {
        double sum = 0;
        for (int j = 0; j < 3; ++j) sum += stress[static_cast<std::size_t>(j)] * b(j, q);
        stiffness(2 * node(e, p / 2) + p % 2, 2 * node(e, q / 2) + q % 2) += sum;
      }
    }
  }

  // The product of the rows r of a and c of b.
  using Modes = Eigen::Matrix<double, Eigen::Dynamic, 3>;
  [[nodiscard]] static double row_product(const Modes& a, Eigen::Index r, const Modes& b,
                                          Eigen::Index c) {
    return a(r, 0) * b(c, 0) + a(r, 1) * b(c, 1) + a(r, 2) * b(c, 2);
  }

  [[nodiscard]] Eigen::MatrixXd solve(Eigen::MatrixXd stiffness,
                                      const Eigen::MatrixXd& mass) const {
    const Eigen::Index n = mass.rows();
    Modes rigid = Modes::Zero(2 * n, 3);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Vec2& x = mesh_.nodes[static_cast<std::size_t>(i)];
      rigid(2 * i, 0) = rigid(2 * i + 1, 1) = 1;
      rigid(2 * i, 2) = -x.y();
      rigid(2 * i + 1, 2) = x.x();
    }
    // Inertia relief: forces less the mass times the rigid acceleration they cause. The density
    // cancels, and about the centroid the rigid modes are orthogonal in mass.
    Modes inertial(2 * n, 3);
    for (int axis = 0; axis < 2; ++axis) {
      using Stride = Eigen::InnerStride<2>;
      for (int mode = 0; mode < 3; ++mode)
        Eigen::Map<Eigen::VectorXd, 0, Stride>(inertial.col(mode).data() + axis, n) =
            mass * Eigen::Map<const Eigen::VectorXd, 0, Stride>(rigid.col(mode).data() + axis, n);
    }
    for (int mode = 0; mode < 3; ++mode)
      inertial.col(mode) *= 1 / rigid.col(mode).dot(inertial.col(mode));

    const Eigen::Index loads = 2 * static_cast<Eigen::Index>(mesh_.boundary_nodes);
    Eigen::MatrixXd displacement = Eigen::MatrixXd::Identity(2 * n, loads);
    for (Eigen::Index c = 0; c < loads; ++c)
      for (Eigen::Index r = 0; r < 2 * n; ++r)
        displacement(r, c) -= row_product(inertial, r, rigid, c);

    // Stiffness against rigid modes makes the matrix definite; balanced loads do not feel it.
    rigid.col(2) /= rigid.col(2).norm() / std::sqrt(static_cast<double>(n));
    const double stiff = stiffness.trace() / static_cast<double>(2 * n * n);
    for (Eigen::Index c = 0; c < 2 * n; ++c)
      for (Eigen::Index r = 0; r < 2 * n; ++r)
        stiffness(r, c) += stiff * row_product(rigid, r, rigid, c);
    // LDLT, a column at a time: where Eigen multiplies large matrices, it adds up in portions that
    // suit the caches of the processor, and the last bits would depend on it.
    const Eigen::LDLT<Eigen::MatrixXd> factors(stiffness);
    for (Eigen::Index i = 0; i < loads; ++i) {
      auto displaced = displacement.col(i);
      factors.solveInPlace(displaced);
    }
    return displacement;
  }

  Mesh mesh_;
  Eigen::MatrixXd stress_;       // 3 elements x 2 boundary nodes, compression positive
  Eigen::MatrixXd flexibility_;  // 2 boundary nodes squared, or empty
};

}  // namespace riprap
