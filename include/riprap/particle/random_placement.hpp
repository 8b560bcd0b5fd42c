// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// What all random assemblies have in common: polygons at random places, without overlap.

#include <cstdint>
#include <optional>
#include <vector>

#include <riprap/core/linkage.hpp>
#include <riprap/geometry/prescribed_polygon.hpp>
#include <riprap/geometry/random_polygon.hpp>
#include <riprap/particle/assembly.hpp>

namespace riprap {

/// Outline of a sample inside a ring of boundary particles.
enum class SampleOutline { circle, rectangle };

/// What a random assembly is made of.
struct RandomAssembly {
  /// Particles. Those of the ring are among them (random_assembly); platens come on top
  /// (random_platen_assembly); a periodic cell has no others (random_periodic_assembly).
  unsigned count = 500;
  double mean_diameter = 0.016;  ///< of the circle of equal area [m]; see `diameters`
  double thickness = 0.016;      ///< [m]; keep it near the diameter, see docs/choices.md
  std::uint64_t seed = 1;
  PolygonShape shape = {};
  double smallest_diameter = 0.7;  ///< over the mean [-]; diameters are uniform in between
  double largest_diameter = 1.3;   ///< over the mean [-]
  double solid_fraction = 0.45;    ///< before compaction [-]
  double dense_fraction = 0.88;    ///< expected after compaction [-]; sets the boundary's count
  /// Distance along the ring, when dense, over the particles' extent [-]. Boundary particles do not
  /// touch each other; below 1 the ring stays closed when shear stretches it.
  double boundary_spacing = 0.8;
  /// Diameters of the circles of equal area [m], one for each particle, in any order: they are
  /// shuffled. Their mean takes the place of mean_diameter. Empty: drawn from the range above.
  std::vector<double> diameters = {};
  /// Outlines to choose from at random, turned at random and scaled to the diameters; their own
  /// size and place do not count. Empty: random polygons of `shape`.
  std::vector<ConvexPolygon> outlines = {};
  /// Of random_assembly; the others are rectangles.
  SampleOutline sample_outline = SampleOutline::circle;
  /// Width along axis 1 over height along axis 2 [-] of a rectangle; 1 for a circle.
  double aspect_ratio = 1;
  /// Of the walls of random_platen_assembly: smooth (Motion::platen) or rough (Motion::wall).
  Motion walls = Motion::platen;
  /// Shapes by distributions of corners, elongation and angularity, in place of `shape`; not with
  /// `outlines`.
  std::optional<PrescribedShape> prescribed_shape = std::nullopt;

  /// Throws InvalidInput that names the value and the rule.
  void validate() const;
};

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/particle/random_placement.ipp>
#endif
