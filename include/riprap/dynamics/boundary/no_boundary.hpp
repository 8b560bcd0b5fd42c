// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// No driven boundary: fixed and prescribed bodies keep the velocities they were given.

#include <vector>

#include <riprap/dynamics/boundary/concepts.hpp>

namespace riprap {

/// Sets nothing.
struct NoBoundary {
  void drive(std::vector<Body>&, double) const {}
};

static_assert(Boundary<NoBoundary>);

}  // namespace riprap
