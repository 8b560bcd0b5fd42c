// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The role of the body force: gravity, or any other acceleration of free bodies.

#include <concepts>

#include <riprap/core/policy.hpp>
#include <riprap/core/vec2.hpp>
#include <riprap/particle/body.hpp>

namespace riprap {

namespace requirements {

/// `body_force(body)` -> Vec2 [m/s^2], force over mass, at the centroid. Const, for one body force
/// serves all bodies.
template <class F>
concept BodyForceCall = requires(const F& body_force, const Body& body) {
  { body_force(body) } -> std::convertible_to<Vec2>;
};

}  // namespace requirements

/// A `BodyForce` accelerates free bodies. The simulation books its work.
template <class F>
concept BodyForce = Policy<F> && requirements::BodyForceCall<F>;

template <class F>
consteval bool check_body_force() {
  check_policy<F>();
  static_assert(requirements::BodyForceCall<F>,
                "riprap: a BodyForce must have Vec2 operator()(const Body&) const");
  return BodyForce<F>;
}

}  // namespace riprap
