// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Four rigid, smooth walls that close in on the middle between them.

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <riprap/core/errors.hpp>
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
  [[nodiscard]] double solid_area() const { return free_area(particles_); }  ///< [m^2]
  /// Free particles whose centroid lies outside.
  [[nodiscard]] std::size_t lost() const {
    std::size_t count = 0;
    for (const Body& body : particles_.bodies()) {
      const Vec2& x = body.position;
      count += body.is_free() &&
               (x.x() < low_.x() || x.y() < low_.y() || x.x() > high_.x() || x.y() > high_.y());
    }
    return count;
  }

 private:
  const Particles& particles_;
  Vec2 low_;
  Vec2 high_;
};

/// Moves the inner face of every body of Motion::platen with v = -rate x along its normal, x from
/// the middle between the faces at the start: one platen on each side of the sample, its centroid
/// on axis 1 or 2 through the middle, its inner face across that axis. Contacts with platens carry
/// no tangential force. A platen that has come to the end of its neighbours is a SimulationError.
class RigidPlatens {
 public:
  /// Shortening rates along axes 1 and 2 [1/s], positive in compression.
  void set_rate(double axis_1, double axis_2) {
    require_finite("RigidPlatens: rate along axis 1", axis_1);
    require_finite("RigidPlatens: rate along axis 2", axis_2);
    rate_ = {axis_1, axis_2};
  }
  [[nodiscard]] const Vec2& rate() const { return rate_; }

  /// Throws InvalidInput unless there is one platen on each side.
  void enclose(const Assembly& /*assembly*/, const Particles& particles) {
    refuse_motion(particles, Motion::strain_field, "RigidPlatens moves platens only");
    platens_.clear();
    const Vec2 among = middle_of_centroids(particles);
    for (BodyIndex i = 0; i < particles.size(); ++i)
      if (particles.body(i).motion == Motion::platen)
        platens_.push_back(platen(particles, i, among));
    int sides = 0;
    for (const Platen& p : platens_) sides |= 1 << (2 * p.axis + (p.to_face > 0 ? 1 : 0));
    if (platens_.size() != 4 || sides != 0b1111)
      throw InvalidInput("RigidPlatens needs four bodies of Motion::platen, one on each side of "
                         "the middle between them; the assembly has " +
                         std::to_string(platens_.size()));
    centre_ = region(particles).centre();
  }

  void drive(std::vector<Body>& bodies, double /*time_step*/) const {
    const auto [low, high] = faces([&bodies](BodyIndex i) { return bodies[i].position; });
    for (const Platen& p : platens_) {
      Body& body = bodies[p.body];
      const int across = 1 - p.axis;
      if (low[across] < body.position[across] - p.reach ||
          high[across] > body.position[across] + p.reach)
        throw SimulationError("the platens no longer close the sample: one has passed the end of "
                              "its neighbours");
      body.velocity = Vec2{0, 0};
      body.velocity[p.axis] =
          -rate_[p.axis] * (body.position[p.axis] + p.to_face - centre_[p.axis]);
      body.angular_velocity = 0;
    }
  }

  [[nodiscard]] PlatenRegion region(const Particles& particles) const {
    const auto [low, high] =
        faces([&particles](BodyIndex i) { return particles.body(i).position; });
    return {particles, low, high};
  }

 private:
  struct Platen {
    BodyIndex body = 0;
    int axis = 0;        ///< along which it moves: 0 or 1
    double to_face = 0;  ///< from its centroid to its inner face along that axis [m]
    double reach = 0;    ///< from its centroid to its nearer end across that axis [m]
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
  [[nodiscard]] static Vec2 middle_of_centroids(const Particles& particles) {
    Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
    Vec2 high = -low;
    for (const Body& body : particles.bodies()) {
      if (body.motion != Motion::platen) continue;
      low = componentwise_min(low, body.position);
      high = componentwise_max(high, body.position);
    }
    return 0.5 * (low + high);
  }

  [[nodiscard]] static Platen platen(const Particles& particles, BodyIndex i, const Vec2& among) {
    const Vec2& centre = particles.body(i).position;
    const Vec2 side = componentwise_abs(centre - among);
    const int axis = side.x() >= side.y() ? 0 : 1;
    double nearest = centre[axis];
    double low = centre[1 - axis];
    double high = low;
    for (const Vec2& v : particles.ring(i)) {
      if (std::abs(v[axis] - among[axis]) < std::abs(nearest - among[axis])) nearest = v[axis];
      low = std::min(low, v[1 - axis]);
      high = std::max(high, v[1 - axis]);
    }
    return {i, axis, nearest - centre[axis],
            std::min(high - centre[1 - axis], centre[1 - axis] - low)};
  }

  Vec2 rate_{0, 0};
  Vec2 centre_{0, 0};  // fixed point of the motion
  std::vector<Platen> platens_;
};

static_assert(SampleBoundary<RigidPlatens>);

}  // namespace riprap
