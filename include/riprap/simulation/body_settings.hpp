// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Velocities that a program gives to bodies between steps.

#include <cmath>
#include <cstddef>
#include <string>

#include <riprap/core/errors.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// Throws InvalidInput for a body that is not there.
inline void require_body(const Particles& particles, BodyIndex i) {
  require(i < particles.size(), "body", i, "must be in the simulation");
}

/// Throws InvalidInput for a material without a rock.
inline void require_material(ParticleId id, MaterialIndex material, std::size_t rocks) {
  if (material >= rocks)
    throw InvalidInput(particle_text(id) + ": material = " + std::to_string(material) +
                       ": must be below the number of rocks, " + std::to_string(rocks));
}

/// Gives body i a velocity [m/s] and a spin [rad/s]. Throws InvalidInput for a body that is not
/// there and for numbers that are not finite.
inline void set_body_velocity(Particles& particles, BodyIndex i, const Vec2& velocity,
                              double spin) {
  require_body(particles, i);
  if (!is_finite(velocity) || !std::isfinite(spin))
    throw InvalidInput(particle_text(particles.ancestry(i).id) + ": velocity (" +
                       to_text(velocity.x()) + ", " + to_text(velocity.y()) + ") m/s, spin " +
                       to_text(spin) + " rad/s: must be finite");
  particles.body(i).velocity = velocity;
  particles.body(i).angular_velocity = spin;
}

/// The same with the velocity of its material point at `point` [m], about which it turns.
inline void set_body_velocity_about(Particles& particles, BodyIndex i, const Vec2& point,
                                    const Vec2& velocity, double spin) {
  require_body(particles, i);
  const Vec2 arm = particles.body(i).position - point;
  set_body_velocity(particles, i, velocity + spin * perpendicular(arm), spin);
}

}  // namespace riprap
