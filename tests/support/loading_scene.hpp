// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A view of a test whose numbers are set by hand, for controls and end conditions.

#include <cmath>
#include <cstdint>

#include <riprap/core/stress2.hpp>
#include <riprap/core/vec2.hpp>

namespace riprap::test {

struct LoadingScene {
  struct Sim {
    double step = 1e-6;  // [s]
    [[nodiscard]] double time_step() const { return step; }
  } sim{};
  Vec2 stretch{1, 1};
  Stress2 state{};
  double time = 0;  // since the start of the stage [s]
  double confining_pressure = 2e6;
  std::uint64_t stage_steps = 0;
  bool at_check = false;

  [[nodiscard]] const Stress2& stress() const { return state; }
  [[nodiscard]] double stress(int axis) const { return axis == 1 ? state.s11 : state.s22; }
  [[nodiscard]] double strain(int axis) const { return 1 - stretch[axis - 1]; }
  [[nodiscard]] double volumetric_strain() const { return 1 - stretch.prod(); }
  [[nodiscard]] double stage_time() const { return time; }
  /// Inertial number times the square root of the pressure, for numbers that are easy to check.
  [[nodiscard]] double rate_at(double inertia, double pressure) const {
    return inertia * std::sqrt(pressure);
  }
  [[nodiscard]] double sample_stiffness() const { return 6e8; }
  [[nodiscard]] double servo_response() const { return 2.5e-3; }
};

}  // namespace riprap::test
