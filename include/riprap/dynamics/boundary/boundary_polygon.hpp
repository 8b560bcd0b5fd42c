// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The region inside the ring of boundary particles: its area, how much of it is rock, and which
/// particles have left it.

#include <cmath>
#include <string>
#include <vector>

#include <riprap/core/argsort.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/core/linkage.hpp>
#include <riprap/core/stress2.hpp>
#include <riprap/dynamics/boundary/concepts.hpp>
#include <riprap/geometry/cut.hpp>
#include <riprap/geometry/overlap.hpp>
#include <riprap/geometry/polygon_properties.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// Middle of the ring of boundary particles [m]: of the circle that fits the centroids of the
/// bodies of Motion::strain_field best, by least squares of the squared distances (Kasa 1976).
/// Rounded to 2e-12 of the radius, so that a ring about the origin has exactly the origin as its
/// centre.
[[nodiscard]] Vec2 ring_centre(const Particles& particles);

/// The polygon through the centroids of the bodies of Motion::strain_field, in order of their
/// direction from the centre. It need not be convex. Reads the particles at every call.
class BoundaryPolygon {
 public:
  /// Throws InvalidInput for fewer than three.
  explicit BoundaryPolygon(const Particles& particles);
  /// @param centre about which the ring is strained [m]
  BoundaryPolygon(const Particles& particles, const Vec2& centre)
      : particles_(particles), centre_(centre) {
    std::vector<BodyIndex> found;
    std::vector<double> directions;
    for (BodyIndex i = 0; i < particles.size(); ++i) {
      if (particles.body(i).motion != Motion::strain_field) continue;
      found.push_back(i);
      const Vec2 from_centre = particles.body(i).position - centre;
      directions.push_back(std::atan2(from_centre.y(), from_centre.x()));
    }
    if (found.size() < 3)
      throw InvalidInput("a sample needs at least 3 boundary particles of Motion::strain_field; "
                         "the assembly has " +
                         std::to_string(found.size()));
    for (const std::size_t k : argsort(directions)) members_.push_back(found[k]);
  }

  [[nodiscard]] const std::vector<BodyIndex>& members() const { return members_; }

  [[nodiscard]] std::vector<Vec2> vertices() const;

  /// Area of the assembly [m^2].
  [[nodiscard]] double area() const { return area_properties(vertices()).area; }

  [[nodiscard]] const Vec2& centre() const { return centre_; }  ///< [m]

  /// Largest distances from the centre along axes 1 and 2 [m].
  [[nodiscard]] Vec2 semi_axes() const;

  /// Area of rock inside [m^2]: all free particles, and of each boundary particle the part between
  /// the two sides of the polygon that meet at its centroid. What neighbours on the ring have in
  /// common inside counts once.
  [[nodiscard]] double solid_area() const;

  /// Free particles whose centroid lies outside.
  [[nodiscard]] std::size_t lost() const;

 private:
  [[nodiscard]] static std::vector<Vec2> part_on_left(Ring ring, const Line& line);
  [[nodiscard]] static double area_on_left(Ring ring, const Line& line) {
    return area_properties(part_on_left(ring, line)).area;
  }

  // Part of a convex ring to the left of both sides (a reflex corner: of either).
  [[nodiscard]] static double area_in_wedge(Ring ring, const Vec2& side_in, const Vec2& side_out,
                                            const Vec2& corner);

  const Particles& particles_;
  Vec2 centre_;
  std::vector<BodyIndex> members_;
};

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/dynamics/boundary/boundary_polygon.ipp>
#endif
