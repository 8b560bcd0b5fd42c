// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Four rigid walls, smooth or rough, that close in on the middle between them.

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/core/linkage.hpp>
#include <riprap/dynamics/boundary/concepts.hpp>
#include <riprap/particle/assembly.hpp>

namespace riprap {

/// The rectangle that four platens leave between them.
class PlatenRegion {
 public:
  PlatenRegion(const Particles& particles, const Vec2& low, const Vec2& high)
      : particles_(particles), low_(low), high_(high) {}

  [[nodiscard]] double area() const { return (high_ - low_).prod(); }        ///< [m^2]
  [[nodiscard]] Vec2 centre() const { return 0.5 * (low_ + high_); }         ///< [m]
  [[nodiscard]] Vec2 semi_axes() const { return 0.5 * (high_ - low_); }      ///< [m]
  [[nodiscard]] double solid_area() const { return rock_area(particles_); }  ///< [m^2]
  /// Free particles whose centroid lies outside.
  [[nodiscard]] std::size_t lost() const;

 private:
  const Particles& particles_;
  Vec2 low_;
  Vec2 high_;
};

/// Moves the inner face of every body of Motion::platen or Motion::wall with v = -rate x along its
/// normal, x from the middle between the faces at the start: one on each side of the sample, its
/// centroid on axis 1 or 2 through the middle, its inner face across that axis. Contacts with a
/// body of Motion::platen carry no tangential force, those with one of Motion::wall that of the
/// contact law. One that has come to the end of its neighbours is a SimulationError.
class RigidPlatens {
 public:
  /// Shortening rates along axes 1 and 2 [1/s], positive in compression.
  void set_rate(double axis_1, double axis_2);
  [[nodiscard]] const Vec2& rate() const { return rate_; }

  /// Throws InvalidInput unless there is one platen on each side.
  void enclose(const Assembly& /*assembly*/, const Particles& particles);

  /// Throws InvalidInput for a platen of its own.
  void remove(BodyIndex i);

  void drive(std::vector<Body>& bodies, double /*time_step*/) const;

  [[nodiscard]] PlatenRegion region(const Particles& particles) const;

  static constexpr bool names_all_members = true;
  static void for_each_field(auto& self, auto&& visit) {
    visit("rate", self.rate_);
    visit("centre", self.centre_);
    visit("platens", self.platens_);
  }

 private:
  struct Platen {
    BodyIndex body = 0;
    int axis = 0;        ///< along which it moves: 0 or 1
    double to_face = 0;  ///< from its centroid to its inner face along that axis [m]
    double reach = 0;    ///< from its centroid to its nearer end across that axis [m]

    static void for_each_field(auto& self, auto&& visit) {
      visit("body", self.body);
      visit("axis", self.axis);
      visit("to_face", self.to_face);
      visit("reach", self.reach);
    }
  };

  // Corners of the rectangle between the inner faces.
  template <class PositionOf>
  [[nodiscard]] std::pair<Vec2, Vec2> faces(PositionOf&& position_of) const {
    Vec2 low{0, 0};
    Vec2 high{0, 0};
    for (const Platen& p : platens_)
      (p.to_face > 0 ? low : high)[p.axis] = position_of(p.body)[p.axis] + p.to_face;
    return {low, high};
  }

  // Of the box around the centroids of the platens.
  [[nodiscard]] static Vec2 middle_of_centroids(const Particles& particles);

  [[nodiscard]] static Platen platen(const Particles& particles, BodyIndex i, const Vec2& among);

  Vec2 rate_{0, 0};
  Vec2 centre_{0, 0};  // fixed point of the motion
  std::vector<Platen> platens_;
};

static_assert(SampleBoundary<RigidPlatens>);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/dynamics/boundary/rigid_platens.ipp>
#endif
