// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// How localised a field of local strain is, and the direction of its band. Optional: not part of
/// riprap.hpp.

#include <span>

#include <riprap/core/linkage.hpp>
#include <riprap/core/vec2.hpp>
#include <riprap/measurement/local_strain.hpp>

namespace riprap {

/// Measures of the deviatoric strain g over the areas A of triangles, in the reference state.
struct StrainLocalisation {
  /// (sum A g)^2 / (sum A sum A g^2) [-]: 1 where all have the same strain, and the share of the
  /// area where one part has all of it, evenly.
  double participation_ratio = 0;
  /// Of sum A g, in the triangles of largest g that make up `area_share` of the area [-]; the last
  /// triangle counts in part. Equal to area_share where all have the same strain.
  double strain_share = 0;
  /// Of sum A g, in the band [-]: the largest connected part of those triangles, by A g; triangles
  /// with a common corner are connected.
  double band_share = 0;
  // The principal axes of the second moment of the area of the band, weighted by g, about its
  // centroid.
  Vec2 centre{0, 0};     ///< [m]
  double direction = 0;  ///< of the major axis, from axis 1 [rad], in (-pi/2, pi/2]
  /// Square root of the ratio of the principal moments [-], >= 1: length over thickness of an even
  /// band. Near 1 it is no band, or several that cross, and the direction says nothing.
  double elongation = 1;
  double thickness = 0;  ///< sqrt(12 times the minor moment), of an even straight band [m]
};

/// Throws InvalidInput unless `area_share` is in (0, 1]. All zero without any strain.
[[nodiscard]] StrainLocalisation strain_localisation(std::span<const StrainTriangle> triangles,
                                                     double area_share = 0.1);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/measurement/strain_localisation.ipp>
#endif
