// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Pieces go on as parts of the rigid body they came from: the default inheritance.

#include <riprap/breakage/inheritance/concepts.hpp>

namespace riprap {

/// v + omega x r: mass, momentum, angular momentum and kinetic energy are those of the parent.
struct RigidField {
  void operator()(const Body& parent, Body& piece) const {
    piece.velocity = parent.velocity_at(piece.position - parent.position);
    piece.angular_velocity = parent.angular_velocity;
  }
};

static_assert(Inheritance<RigidField>);

}  // namespace riprap
