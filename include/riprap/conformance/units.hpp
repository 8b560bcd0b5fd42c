// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Other units of length, mass and time: what a formula gives must not depend on them.

#include <riprap/core/compiler.hpp>

namespace riprap {

/// By how much the numbers grow when metre, kilogram and second are replaced. By default:
/// millimetre, gram, millisecond.
struct Units {
  double length = 1e3;
  double mass = 1e3;
  double time = 1e3;

  [[nodiscard]] double velocity() const { return length / time; }
  [[nodiscard]] double area() const { return length * length; }
  [[nodiscard]] double force() const { return mass * length / (time * time); }
  [[nodiscard]] double stress() const { return mass / (length * time * time); }
  [[nodiscard]] double energy() const { return force() * length; }
  [[nodiscard]] double stiffness() const { return mass / (time * time); }
};

}  // namespace riprap
