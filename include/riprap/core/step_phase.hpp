// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The phases of a time step, for measuring the time that each of them takes.

#include <array>
#include <cstddef>
#include <cstdint>

#include <riprap/core/compiler.hpp>

namespace riprap {

/// In the order in which they run.
enum class StepPhase : std::uint8_t {
  integration,   ///< boundary, damping, integrator, placing of the vertices
  broad_phase,   ///< validity of the Verlet list; its rebuild
  narrow_phase,  ///< geometry of the contacts
  contact_law,   ///< forces, and their sums
  stress_bound,  ///< screening: which particles may be near breaking
  stress_check,  ///< stress and failure of those
  splitting,     ///< cracks, and the contacts of the pieces
  other          ///< observers, measurement, and what the caller does between steps
};
inline constexpr std::size_t step_phase_count = 8;

[[nodiscard]] constexpr const char* to_text(StepPhase part) {
  constexpr std::array<const char*, step_phase_count> names{
      "integration",  "broad phase",  "narrow phase", "contact law",
      "stress bound", "stress check", "splitting",    "other"};
  return names[static_cast<std::size_t>(part)];
}

/// Do-nothing timer: no time is measured, at no cost.
struct NoPhaseTimer {
  void operator()(StepPhase) const {}
};

}  // namespace riprap
