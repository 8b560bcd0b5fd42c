// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Pieces start at rest. The file to copy for an inheritance of your own.

#include <riprap/breakage/inheritance/concepts.hpp>

namespace riprap {

/// Gives a piece no velocity: the parent's momentum and kinetic energy are lost, as if breaking
/// took them up.
struct AtRest {
  void operator()(const Body& /*parent*/, Body& piece) const {
    piece.velocity = Vec2{0, 0};
    piece.angular_velocity = 0;
  }
};

static_assert(Inheritance<AtRest>);

}  // namespace riprap
