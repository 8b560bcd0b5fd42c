// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Element stresses by a direct solver: the whole particle assembled and solved. Not part of
/// riprap.hpp: an independent check on the influence operator, and the baseline that its speed is
/// measured against.

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/material/rock.hpp>
#include <riprap/stress/boundary_load.hpp>
#include <riprap/stress/determinate_support.hpp>
#include <riprap/stress/element/body_force_shares.hpp>
#include <riprap/stress/element/concepts.hpp>
#include <riprap/stress/element/element_stiffness.hpp>
#include <riprap/stress/element/element_stress.hpp>
#include <riprap/stress/mesher/mesh.hpp>
#include <riprap/stress/mesher/mid_side_nodes.hpp>
#include <riprap/stress/nodal_shares.hpp>
#include <riprap/stress/plane_state/concepts.hpp>

namespace riprap {

/// Sparse finite elements for one particle. The unknowns, their order of elimination and all memory
/// of the free case are set up once; `factorise` and `solve_free` then do the work that one check
/// of a particle costs without an influence operator. Shares no arithmetic with that operator: the
/// inertia that balances a free particle is integrated by quadrature, triangle by triangle.
template <Element E, PlaneState P>
class AssembleAndSolve {
 public:
  /// Also factorises. Throws InvalidInput for a mesh, a rock, a thickness or a support that breaks
  /// a rule.
  /// @param mesh      anywhere in the plane; its centroid need not be the origin. Mid-side nodes
  ///                  are added where the element has them: points and nodes are those of `mesh()`
  /// @param thickness out of plane [m]
  /// @param support   its nodes are of `mesh()` too, which mesh_for_element makes beforehand
  AssembleAndSolve(Mesh mesh, const E& element, const P& plane, const Rock& rock, double thickness,
                   const DeterminateSupport& support)
      : mesh_(mesh_for_element<E::nodes>(std::move(mesh))), element_(element),
        elasticity_(plane.elasticity(rock)), density_(rock.density), thickness_(thickness) {
    rock.validate();
    require_positive("AssembleAndSolve.thickness", thickness);
    integrate_mass();
    number_unknowns(support);
    build_pattern();
    factorise();
  }
  /// Held by nodes on opposite sides of `mesh()`.
  AssembleAndSolve(const Mesh& mesh, const E& element, const P& plane, const Rock& rock,
                   double thickness)
      : AssembleAndSolve(mesh, element, plane, rock, thickness,
                         DeterminateSupport::on_opposite_sides(mesh_for_element<E::nodes>(mesh))) {}
  AssembleAndSolve(const AssembleAndSolve&) = delete;
  AssembleAndSolve& operator=(const AssembleAndSolve&) = delete;

  [[nodiscard]] const Mesh& mesh() const { return mesh_; }

  /// Assembles the stiffness of the free particle again and factorises it.
  void factorise() {
    std::fill_n(stiffness_.valuePtr(), stiffness_.nonZeros(), 0.0);
    auto slot = slots_.begin();
    for (std::size_t e = 0; e < mesh_.size(); ++e) {
      const ElementStiffness<E> k = stiffness_of(e);
      for (Eigen::Index q = 0; q < k.cols(); ++q)
        for (Eigen::Index p = 0; p < k.rows(); ++p, ++slot)
          if (*slot >= 0) stiffness_.valuePtr()[*slot] += k(p, q);
    }
    cholesky_.factorize(stiffness_);
    if (cholesky_.info() != Eigen::Success)
      throw SimulationError("AssembleAndSolve: stiffness of the free particle is not definite");
  }

  /// Stresses of the free particle: what the loads leave over is balanced by its inertia. Uses the
  /// last factorisation. Throws InvalidInput for a load that is not on the boundary or not finite.
  void solve_free(std::span<const BoundaryLoad> loads, ElementStress& stress) {
    forces_.setZero(2 * node_count());
    add_loads(loads, forces_);
    subtract_inertia(loads, forces_);
    for (std::size_t i = 0; i < unknown_of_.size(); ++i)
      if (unknown_of_[i] >= 0) right_side_[unknown_of_[i]] = forces_[static_cast<Eigen::Index>(i)];
    solution_ = cholesky_.solve(right_side_);
    displacements_.setZero(2 * node_count());
    for (std::size_t i = 0; i < unknown_of_.size(); ++i)
      if (unknown_of_[i] >= 0)
        displacements_[static_cast<Eigen::Index>(i)] = solution_[unknown_of_[i]];
    find_element_stress(element_, mesh_, elasticity_, displacements_, stress);
  }

  /// Stresses while two boundary points are held fast in both directions, by Lagrange multipliers,
  /// and the loads act without inertia; loads at the pins go straight into them. Returns the forces
  /// [N] of the two pins on the particle. Sets up everything anew.
  std::array<Vec2, 2> solve_pinned(std::span<const BoundaryLoad> loads,
                                   const std::array<BoundaryPoint, 2>& pins,
                                   ElementStress& stress) const {
    for (const BoundaryPoint& pin : pins)
      require_boundary_load(pin, Vec2{0, 0}, mesh_.boundary_nodes);
    const double apart = (mesh_.position(pins[0]) - mesh_.position(pins[1])).norm();
    require_positive("AssembleAndSolve distance of the pins", apart);
    // Multipliers in units of a stiffness, so that all entries of the matrix are of one size.
    const double scale = mean_stiffness();
    const Eigen::Index n = 2 * node_count();
    Eigen::SparseMatrix<double> matrix(n + 4, n + 4);
    const auto entries = saddle_point_entries(pins, scale);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SparseLU<Eigen::SparseMatrix<double>> lu(matrix);
    if (lu.info() != Eigen::Success)
      throw SimulationError("AssembleAndSolve: stiffness of the pinned particle is singular");

    Eigen::VectorXd right_side = Eigen::VectorXd::Zero(n + 4);
    add_loads(loads, right_side);
    const Eigen::VectorXd solution = lu.solve(right_side);
    find_element_stress(element_, mesh_, elasticity_, solution, stress);
    return {-scale * solution.segment<2>(n), -scale * solution.segment<2>(n + 2)};
  }

 private:
  using Triplets = std::vector<Eigen::Triplet<double>>;

  [[nodiscard]] Eigen::Index node_count() const {
    return static_cast<Eigen::Index>(mesh_.nodes.size());
  }
  [[nodiscard]] ElementStiffness<E> stiffness_of(std::size_t e) const {
    return element_stiffness(element_, mesh_, e, elasticity_, thickness_);
  }
  [[nodiscard]] NodalShares shares(const BoundaryPoint& at) const {
    return nodal_shares(at, E::nodes == 6, mesh_.boundary_nodes);
  }
  // Middles of the edges, where three points of equal weight integrate quadratics exactly.
  [[nodiscard]] std::array<Vec2, 3> edge_middles(std::size_t e) const {
    const auto [p, q, r] = mesh_.triangle(e);
    return {0.5 * (p + q), 0.5 * (q + r), 0.5 * (r + p)};
  }

  void integrate_mass() {
    Vec2 first{0, 0};
    for (std::size_t e = 0; e < mesh_.size(); ++e) {
      const double m = density_ * thickness_ * mesh_.area(e);
      mass_ += m;
      first += m * mesh_.centroid(e);
    }
    centre_ = first / mass_;
    for (std::size_t e = 0; e < mesh_.size(); ++e)
      for (const Vec2& x : edge_middles(e))
        inertia_ += density_ * thickness_ * mesh_.area(e) / 3 * (x - centre_).squaredNorm();
  }

  // -1 marks a held direction of a node.
  void number_unknowns(const DeterminateSupport& support) {
    for (const std::uint32_t node : {support.fixed, support.guided})
      require(node < mesh_.nodes.size(), "DeterminateSupport node", node, "must be in the mesh");
    require(support.fixed != support.guided, "DeterminateSupport.guided", support.guided,
            "must be another node than `fixed`");
    const Vec2 between = mesh_.nodes[support.guided] - mesh_.nodes[support.fixed];
    const std::size_t across = std::abs(between.x()) > std::abs(between.y()) ? 1 : 0;
    unknown_of_.assign(2 * mesh_.nodes.size(), 0);
    unknown_of_[2 * std::size_t{support.fixed}] = -1;
    unknown_of_[2 * std::size_t{support.fixed} + 1] = -1;
    unknown_of_[2 * std::size_t{support.guided} + across] = -1;
    Eigen::Index next = 0;
    for (Eigen::Index& unknown : unknown_of_)
      if (unknown >= 0) unknown = next++;
    right_side_.setZero(next);
  }

  // The lower half of the stiffness, and the place in it of every entry of every element.
  void build_pattern() {
    Triplets entries;
    const auto for_each_entry = [&](auto&& visit) {
      for (std::size_t e = 0; e < mesh_.size(); ++e) {
        const auto dof = degrees_of_freedom<E>(mesh_, e);
        for (const Eigen::Index q : dof)
          for (const Eigen::Index p : dof)
            visit(unknown_of_[static_cast<std::size_t>(p)],
                  unknown_of_[static_cast<std::size_t>(q)]);
      }
    };
    for_each_entry([&](Eigen::Index row, Eigen::Index column) {
      if (column >= 0 && row >= column)
        entries.emplace_back(static_cast<int>(row), static_cast<int>(column), 0.0);
    });
    stiffness_.resize(right_side_.size(), right_side_.size());
    stiffness_.setFromTriplets(entries.begin(), entries.end());
    slots_.reserve(element_unknowns<E> * element_unknowns<E> * mesh_.size());
    for_each_entry([&](Eigen::Index row, Eigen::Index column) {
      slots_.push_back(column >= 0 && row >= column
                           ? &stiffness_.coeffRef(row, column) - stiffness_.valuePtr()
                           : -1);
    });
    cholesky_.analyzePattern(stiffness_);
  }

  void add_loads(std::span<const BoundaryLoad> loads, Eigen::VectorXd& forces) const {
    for (const BoundaryLoad& load : loads) {
      require_boundary_load(load.at, load.force_body, mesh_.boundary_nodes);
      const NodalShares spread = shares(load.at);
      for (std::size_t k = 0; k < spread.count; ++k)
        forces.segment<2>(2 * Eigen::Index{spread.nodes[k]}) += spread.weights[k] * load.force_body;
    }
  }

  // D'Alembert: density times the rigid acceleration, as a body force.
  void subtract_inertia(std::span<const BoundaryLoad> loads, Eigen::VectorXd& forces) const {
    Vec2 force{0, 0};
    double moment = 0;
    for (const BoundaryLoad& load : loads) {
      force += load.force_body;
      moment += cross(mesh_.position(load.at) - centre_, load.force_body);
    }
    const Vec2 acceleration = force / mass_;
    const double spin = moment / inertia_;
    for (std::size_t e = 0; e < mesh_.size(); ++e) {
      const double mass = density_ * thickness_ * mesh_.area(e);
      const auto nodal = body_force_shares<E::nodes>(mesh_.triangle(e), [&](const Vec2& x) {
        return Vec2(mass * (acceleration + spin * perpendicular(x - centre_)));
      });
      for (std::size_t k = 0; k < E::nodes; ++k)
        forces.segment<2>(2 * Eigen::Index{mesh_.node(e, k)}) -= nodal[k];
    }
  }

  [[nodiscard]] double mean_stiffness() const {
    double trace = 0;
    for (std::size_t e = 0; e < mesh_.size(); ++e) trace += stiffness_of(e).trace();
    return trace / static_cast<double>(2 * node_count());
  }

  [[nodiscard]] Triplets saddle_point_entries(const std::array<BoundaryPoint, 2>& pins,
                                              double scale) const {
    Triplets entries;
    for (std::size_t e = 0; e < mesh_.size(); ++e) {
      const ElementStiffness<E> k = stiffness_of(e);
      const auto dof = degrees_of_freedom<E>(mesh_, e);
      for (std::size_t p = 0; p < dof.size(); ++p)
        for (std::size_t q = 0; q < dof.size(); ++q)
          entries.emplace_back(static_cast<int>(dof[p]), static_cast<int>(dof[q]),
                               k(static_cast<Eigen::Index>(p), static_cast<Eigen::Index>(q)));
    }
    auto row = static_cast<int>(2 * node_count());
    for (const BoundaryPoint& pin : pins)
      for (int axis = 0; axis < 2; ++axis, ++row) {
        const NodalShares held = shares(pin);
        for (std::size_t k = 0; k < held.count; ++k) {
          const int column = 2 * static_cast<int>(held.nodes[k]) + axis;
          entries.emplace_back(row, column, scale * held.weights[k]);
          entries.emplace_back(column, row, scale * held.weights[k]);
        }
      }
    return entries;
  }

  Mesh mesh_;
  E element_;
  Eigen::Matrix3d elasticity_;
  double density_ = 0;
  double thickness_ = 0;

  double mass_ = 0;
  Vec2 centre_{0, 0};
  double inertia_ = 0;

  std::vector<Eigen::Index> unknown_of_;  // degree of freedom -> unknown
  Eigen::SparseMatrix<double> stiffness_;
  std::vector<std::ptrdiff_t> slots_;  // entries of the elements -> values of the stiffness
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> cholesky_;
  Eigen::VectorXd forces_;
  Eigen::VectorXd right_side_;
  Eigen::VectorXd solution_;
  Eigen::VectorXd displacements_;
};

}  // namespace riprap
