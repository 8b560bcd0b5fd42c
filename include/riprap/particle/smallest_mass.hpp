// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The mass that decides the time step.

#include <algorithm>
#include <limits>

#include <riprap/particle/particles.hpp>

namespace riprap {

/// Mass of the smallest intact free particle [kg]; of all intact ones where none is free;
/// `otherwise` where none is intact.
[[nodiscard]] inline double smallest_intact_mass(const Particles& particles, double otherwise) {
  constexpr double none = std::numeric_limits<double>::infinity();
  double free = none;
  double any = none;
  for (BodyIndex i = 0; i < particles.size(); ++i) {
    const Body& body = particles.body(i);
    if (particles.ancestry(i).generation > 0) continue;
    any = std::min(any, body.mass);
    if (body.is_free()) free = std::min(free, body.mass);
  }
  return free < none ? free : any < none ? any : otherwise;
}

}  // namespace riprap
