// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Local strain and rotation between two states, on a triangulation of centroids: Bagi (1996),
/// Stress and strain in granular assemblies, Mech. Mater. 22, 165-177; compared with other measures
/// in Bagi (2006), Int. J. Solids Struct. 43, 3166-3184. Optional: not part of riprap.hpp.

#include <array>
#include <span>
#include <vector>

#include <riprap/core/linkage.hpp>
#include <riprap/core/vec2.hpp>
#include <riprap/measurement/displacement_gradient.hpp>
#include <riprap/measurement/material_points.hpp>

namespace riprap {

/// Three neighbouring points and the linear displacement field through theirs.
struct StrainTriangle {
  std::array<ParticleId, 3> ids{};
  std::array<Vec2, 3> corners{Vec2{0, 0}, Vec2{0, 0}, Vec2{0, 0}};  ///< in the reference state [m]
  DisplacementGradient gradient{};

  [[nodiscard]] double area() const {  ///< in the reference state [m^2]
    return 0.5 * cross(corners[1] - corners[0], corners[2] - corners[0]);
  }
  [[nodiscard]] Vec2 centroid() const {  ///< in the reference state [m]
    return (corners[0] + corners[1] + corners[2]) / 3;
  }
};

/// The Delaunay triangulation, in the reference state, of the points that are in both states, with
/// the gradient in each triangle. Points of one state alone are left out: the triangles between
/// those around them reach across. A homogeneous deformation is found exactly.
///
/// In a periodic cell positions are those of the bodies themselves, and no triangle reaches across
/// its boundary.
/// @param reference, present in rising order of ids
/// @param least_height triangles at the edge of the sample are left out whose height is below this
///        share of their side on the edge, of which `without_flat_edge` says more [-]
/// Throws InvalidInput unless ids rise and positions are finite.
[[nodiscard]] std::vector<StrainTriangle> local_strain(std::span<const MaterialPoint> reference,
                                                       std::span<const MaterialPoint> present,
                                                       double least_height = 0.2);

/// Mean over the area of all triangles: by Gauss's theorem the gradient that the displacements
/// along the edge of the triangulation give. Zero without triangles.
[[nodiscard]] DisplacementGradient mean_gradient(std::span<const StrainTriangle> triangles);

/// Gradient at a point.
struct PointGradient {
  ParticleId id = 0;
  DisplacementGradient gradient{};
};

/// Mean over the area of the triangles that have a corner at the point, for all points of
/// triangles, in rising order of ids. Strains of a particle are those of this mean.
[[nodiscard]] std::vector<PointGradient> point_gradients(std::span<const StrainTriangle> triangles);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/measurement/local_strain.ipp>
#endif
