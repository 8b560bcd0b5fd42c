// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// No body force. The file to copy for a body force of your own.

#include <riprap/dynamics/body_force/concepts.hpp>

namespace riprap {

/// Accelerates nothing.
struct NoBodyForce {
  [[nodiscard]] Vec2 operator()(const Body&) const { return {0, 0}; }
};

static_assert(BodyForce<NoBodyForce>);

}  // namespace riprap
