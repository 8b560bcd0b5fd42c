// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Element stresses of a body whose displacements are prescribed at some nodes. Not part of
/// riprap.hpp: sparse solvers take long to compile, and no step of a simulation needs them.

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/material/rock.hpp>
#include <riprap/stress/element/concepts.hpp>
#include <riprap/stress/element/element_stiffness.hpp>
#include <riprap/stress/element/element_stress.hpp>
#include <riprap/stress/mesher/mesh.hpp>
#include <riprap/stress/mesher/mid_side_nodes.hpp>
#include <riprap/stress/plane_state/concepts.hpp>

namespace riprap {

/// One component of the displacement of one node.
struct NodeComponent {
  std::uint32_t node = 0;
  std::uint32_t axis = 0;  ///< 0 or 1, for axis 1 or 2
};

/// What the prescribed displacements lead to.
struct Deformation {
  Eigen::VectorXd displacements;  ///< u1, u2 of node 0, of node 1, ... [m]
  Eigen::VectorXd forces;         ///< that hold the nodes, likewise [N]; zero where a node is free
  ElementStress stress;

  [[nodiscard]] Vec2 displacement(std::uint32_t node) const {
    return displacements.segment<2>(2 * Eigen::Index{node});
  }
  [[nodiscard]] Vec2 force(std::uint32_t node) const {
    return forces.segment<2>(2 * Eigen::Index{node});
  }
  /// All of it is linear in what was prescribed.
  void scale(double factor) {
    displacements *= factor;
    forces *= factor;
    stress.values() *= factor;
  }
};

/// Sparse finite elements with some components of displacement prescribed and no other loads.
/// Factorised once for a choice of components; every set of values then costs one solution.
template <Element E, PlaneState P>
class PrescribedDisplacement {
 public:
  /// @param mesh      anywhere in the plane; mid-side nodes are added where the element has them:
  ///                  nodes are those of `mesh()`
  /// @param thickness out of plane [m]
  /// @param held      the prescribed components, each named once, in the order of the values
  /// Throws InvalidInput for a mesh, a rock or a thickness that breaks a rule and for a component
  /// that the mesh does not have, and SimulationError where the held components leave the body free
  /// to move.
  PrescribedDisplacement(Mesh mesh, const E& element, const P& plane, const Rock& rock,
                         double thickness, std::vector<NodeComponent> held)
      : mesh_(mesh_for_element<E::nodes>(std::move(mesh))), element_(element),
        elasticity_(plane.elasticity(rock)), thickness_(thickness), held_(std::move(held)) {
    rock.validate();
    require_positive("PrescribedDisplacement.thickness", thickness);
    number_unknowns();
    assemble();
    factorise();
  }
  PrescribedDisplacement(const PrescribedDisplacement&) = delete;
  PrescribedDisplacement& operator=(const PrescribedDisplacement&) = delete;

  [[nodiscard]] const Mesh& mesh() const { return mesh_; }
  [[nodiscard]] const std::vector<NodeComponent>& held() const { return held_; }

  /// @param values of the held components, in their order [m]
  [[nodiscard]] Deformation solve(std::span<const double> values) const {
    require(values.size() == held_.size(), "PrescribedDisplacement: count of values",
            static_cast<double>(values.size()), "must be one for each held component");
    for (const double value : values) require_finite("PrescribedDisplacement: value [m]", value);
    Deformation d;
    d.displacements.setZero(size());
    for (std::size_t i = 0; i < held_.size(); ++i) d.displacements[place(held_[i])] = values[i];
    const Eigen::VectorXd pull = stiffness_ * d.displacements;
    Eigen::VectorXd right_side(free_count_);
    for (Eigen::Index i = 0; i < size(); ++i)
      if (unknown(i) >= 0) right_side[unknown(i)] = -pull[i];
    if (free_count_ > 0) right_side = cholesky_.solve(right_side).eval();
    for (Eigen::Index i = 0; i < size(); ++i)
      if (unknown(i) >= 0) d.displacements[i] = right_side[unknown(i)];
    const Eigen::VectorXd forces = stiffness_ * d.displacements;
    d.forces.setZero(size());
    for (const NodeComponent& c : held_) d.forces[place(c)] = forces[place(c)];
    find_element_stress(element_, mesh_, elasticity_, d.displacements, d.stress);
    return d;
  }

 private:
  [[nodiscard]] Eigen::Index size() const {
    return 2 * static_cast<Eigen::Index>(mesh_.nodes.size());
  }
  [[nodiscard]] static Eigen::Index place(const NodeComponent& c) {
    return 2 * Eigen::Index{c.node} + Eigen::Index{c.axis};
  }
  [[nodiscard]] Eigen::Index unknown(Eigen::Index place) const {
    return unknown_of_[static_cast<std::size_t>(place)];
  }
  // -1 marks a held component.
  void number_unknowns() {
    unknown_of_.assign(static_cast<std::size_t>(size()), 0);
    for (const NodeComponent& c : held_) {
      require(c.node < mesh_.nodes.size(), "NodeComponent.node", c.node, "must be in the mesh");
      require(c.axis < 2, "NodeComponent.axis", c.axis, "must be 0 or 1");
      Eigen::Index& unknown = unknown_of_[static_cast<std::size_t>(place(c))];
      require(unknown == 0, "NodeComponent.node", c.node, "must not be held twice along one axis");
      unknown = -1;
    }
    for (Eigen::Index& unknown : unknown_of_)
      if (unknown >= 0) unknown = free_count_++;
  }

  void assemble() {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(element_unknowns<E> * element_unknowns<E> * mesh_.size());
    for (std::size_t e = 0; e < mesh_.size(); ++e) {
      const ElementStiffness<E> k = element_stiffness(element_, mesh_, e, elasticity_, thickness_);
      const auto at = degrees_of_freedom<E>(mesh_, e);
      for (std::size_t q = 0; q < at.size(); ++q)
        for (std::size_t p = 0; p < at.size(); ++p)
          entries.emplace_back(static_cast<int>(at[p]), static_cast<int>(at[q]),
                               k(static_cast<Eigen::Index>(p), static_cast<Eigen::Index>(q)));
    }
    stiffness_.resize(size(), size());
    stiffness_.setFromTriplets(entries.begin(), entries.end());
  }

  // Pivots of a body that can still move are round-off beside those of one that cannot.
  void factorise() {
    if (free_count_ == 0) return;
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(static_cast<std::size_t>(stiffness_.nonZeros()));
    for (Eigen::Index column = 0; column < size(); ++column)
      for (Eigen::SparseMatrix<double>::InnerIterator it(stiffness_, column); it; ++it)
        if (unknown(column) >= 0 && unknown(it.row()) >= unknown(column))
          entries.emplace_back(static_cast<int>(unknown(it.row())),
                               static_cast<int>(unknown(column)), it.value());
    Eigen::SparseMatrix<double> free(free_count_, free_count_);
    free.setFromTriplets(entries.begin(), entries.end());
    cholesky_.compute(free);
    if (cholesky_.info() != Eigen::Success ||
        !(cholesky_.vectorD().minCoeff() > 1e-12 * cholesky_.vectorD().maxCoeff()))
      throw SimulationError("PrescribedDisplacement: the held components leave the body free");
  }

  Mesh mesh_;
  E element_;
  Eigen::Matrix3d elasticity_;
  double thickness_ = 0;
  std::vector<NodeComponent> held_;

  std::vector<Eigen::Index> unknown_of_;
  Eigen::Index free_count_ = 0;
  Eigen::SparseMatrix<double> stiffness_;  // of all components, held ones included
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> cholesky_;
};

}  // namespace riprap
