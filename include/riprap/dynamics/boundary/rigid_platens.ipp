// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>

#include <riprap/dynamics/boundary/rigid_platens.hpp>

namespace riprap {

RIPRAP_INLINE std::size_t PlatenRegion::lost() const {
  std::size_t count = 0;
  for (const Body& body : particles_.bodies()) {
    const Vec2& x = body.position;
    count += body.is_free() &&
             (x.x() < low_.x() || x.y() < low_.y() || x.x() > high_.x() || x.y() > high_.y());
  }
  return count;
}

RIPRAP_INLINE void RigidPlatens::set_rate(double axis_1, double axis_2) {
  require_finite("RigidPlatens: rate along axis 1", axis_1);
  require_finite("RigidPlatens: rate along axis 2", axis_2);
  rate_ = {axis_1, axis_2};
}

RIPRAP_INLINE void RigidPlatens::enclose(const Assembly& /*assembly*/, const Particles& particles) {
  refuse_motion(particles, Motion::strain_field, "RigidPlatens moves platens only");
  platens_.clear();
  const Vec2 among = middle_of_centroids(particles);
  for (BodyIndex i = 0; i < particles.size(); ++i)
    if (particles.body(i).is_wall()) platens_.push_back(platen(particles, i, among));
  int sides = 0;
  for (const Platen& p : platens_) sides |= 1 << (2 * p.axis + (p.to_face > 0 ? 1 : 0));
  if (platens_.size() != 4 || sides != 0b1111)
    throw InvalidInput(
        "RigidPlatens needs four bodies of Motion::platen or Motion::wall, one on each side of "
        "the middle between them; the assembly has " +
        std::to_string(platens_.size()));
  centre_ = region(particles).centre();
}

RIPRAP_INLINE void RigidPlatens::remove(BodyIndex i) {
  for (const Platen& p : platens_)
    require(p.body != i, "RigidPlatens: body", i, "is a platen of the sample and must stay");
  for (Platen& p : platens_)
    if (p.body > i) --p.body;
}

RIPRAP_INLINE void RigidPlatens::drive(std::vector<Body>& bodies, double /*time_step*/) const {
  const auto [low, high] = faces([&bodies](BodyIndex i) { return bodies[i].position; });
  for (const Platen& p : platens_) {
    Body& body = bodies[p.body];
    const int across = 1 - p.axis;
    if (low[across] < body.position[across] - p.reach ||
        high[across] > body.position[across] + p.reach)
      throw SimulationError("the platens no longer close the sample: one has passed the end of "
                            "its neighbours");
    body.velocity = Vec2{0, 0};
    body.velocity[p.axis] = -rate_[p.axis] * (body.position[p.axis] + p.to_face - centre_[p.axis]);
    body.angular_velocity = 0;
  }
}

RIPRAP_INLINE PlatenRegion RigidPlatens::region(const Particles& particles) const {
  const auto [low, high] = faces([&particles](BodyIndex i) { return particles.body(i).position; });
  return {particles, low, high};
}

RIPRAP_INLINE Vec2 RigidPlatens::middle_of_centroids(const Particles& particles) {
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 high = -low;
  for (const Body& body : particles.bodies()) {
    if (!body.is_wall()) continue;
    low = componentwise_min(low, body.position);
    high = componentwise_max(high, body.position);
  }
  return 0.5 * (low + high);
}

RIPRAP_INLINE RigidPlatens::Platen RigidPlatens::platen(const Particles& particles, BodyIndex i,
                                                        const Vec2& among) {
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

}  // namespace riprap
