// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Element stresses as a linear function of boundary forces, computed once per particle shape.

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/core/linkage.hpp>
#include <riprap/material/rock.hpp>
#include <riprap/stress/boundary_load.hpp>
#include <riprap/stress/boundary_locator.hpp>
#include <riprap/stress/element/concepts.hpp>
#include <riprap/stress/element/element_matrices.hpp>
#include <riprap/stress/element/element_stress.hpp>
#include <riprap/stress/mesher/mesh.hpp>
#include <riprap/stress/mesher/mid_side_nodes.hpp>
#include <riprap/stress/nodal_shares.hpp>
#include <riprap/stress/plane_state/concepts.hpp>
#include <riprap/stress/sampling_points.hpp>

namespace riprap {

class BandedStiffness;

/// stress = S f. The mesh never changes in the particle's own frame, so neither does S: checking a
/// particle costs one pass over four columns of S per contact (six with six-node elements) instead
/// of assembling and solving.
///
/// The particle is free: a net force and moment are balanced by its inertia (inertia relief), and
/// rigid modes carry no stress. Stress does not depend on Young's modulus.
class InfluenceOperator {
 public:
  InfluenceOperator() = default;

  /// @param mesh      in the body's own frame, centroid at the origin; mid-side nodes are added
  ///                  where the element has them: points of its boundary are those of `mesh()`
  /// @param thickness out of plane [m]
  /// @param with_flexibility also keep the displacements of the boundary (for pinned supports)
  /// Throws InvalidInput for a mesh, a rock or a thickness that breaks a rule, and for an element
  /// or a plane state whose matrices are not finite.
  template <Element E, PlaneState P>
  InfluenceOperator(Mesh mesh, const E& element, const P& plane, const Rock& rock, double thickness,
                    bool with_flexibility)
      : mesh_(mesh_for_element<E::nodes>(std::move(mesh))), rule_(E::sampling_points),
        locator_(mesh_) {
    rock.validate();
    require_positive("InfluenceOperator: thickness", thickness);
    const ElementMatrices elements = element_matrices(mesh_, element);
    const Eigen::Matrix3d elasticity = plane.elasticity(rock);
    build(elements, elasticity.data(), thickness, with_flexibility);
  }

  [[nodiscard]] const Mesh& mesh() const { return mesh_; }
  [[nodiscard]] const BoundaryLocator& locator() const { return locator_; }
  [[nodiscard]] bool empty() const { return stress_.size() == 0; }
  /// Where the stresses are those of: the rows of each component of S.
  [[nodiscard]] SamplingPoints sampling_points() const { return SamplingPoints(mesh_, rule_); }
  /// S [1/m^2]: a column for each boundary node and axis, with the s11 of every sampling point,
  /// then the s22, then the s12.
  [[nodiscard]] const Eigen::MatrixXd& columns() const { return stress_; }

  /// Adds the stresses due to a force [N] at a boundary point. Throws InvalidInput for a point that
  /// is not on the boundary, a force that is not finite and a `stress` of another size than
  /// `sampling_points()`.
  void add_stress(const BoundaryPoint& at, const Vec2& force, ElementStress& stress) const;

  /// Displacement [m] of one boundary point under a force [N] at another, up to a rigid motion that
  /// is the same for all points. Needs the flexibility.
  [[nodiscard]] Vec2 displacement(const BoundaryPoint& of, const BoundaryPoint& at,
                                  const Vec2& force) const;

  [[nodiscard]] std::size_t bytes() const {
    return sizeof(double) * static_cast<std::size_t>(stress_.size() + flexibility_.size());
  }

 private:
  [[nodiscard]] static Eigen::Index column(std::uint32_t node) {
    return 2 * static_cast<Eigen::Index>(node);
  }

  void add_quadratic_stress(const BoundaryPoint& at, const Vec2& force,
                            ElementStress& stress) const;

  void build(const ElementMatrices& elements, const double* elasticity, double thickness,
             bool with_flexibility);
  void assemble(const ElementMatrices& elements, const double* elasticity, double thickness,
                BandedStiffness& stiffness) const;
  [[nodiscard]] std::vector<double> balanced_loads(const ElementMatrices& elements,
                                                   const BandedStiffness& stiffness) const;
  void find_stress(const std::vector<double>& displacement, const BandedStiffness& stiffness,
                   const ElementMatrices& elements, const double* elasticity);

  Mesh mesh_;
  std::span<const TrianglePoint> rule_;  // of the sampling points of an element
  BoundaryLocator locator_;
  Eigen::MatrixXd stress_;       // 3 sampling points x 2 boundary nodes, compression positive
  Eigen::MatrixXd flexibility_;  // 2 boundary nodes squared, or empty
};

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/stress/influence_operator.ipp>
#endif
