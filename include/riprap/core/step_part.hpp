// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The parts of a time step, for those who measure what each of them costs.

#include <array>
#include <cstddef>
#include <cstdint>

#include <riprap/compiler.hpp>

namespace riprap {

/// In the order in which they run.
enum class StepPart : std::uint8_t {
  integration,   ///< boundary, damping, integrator, placing of the vertices
  broad_phase,   ///< is the list of neighbours still good; a new one
  narrow_phase,  ///< geometry of the contacts
  contact_law,   ///< forces, and their sums
  stress_bound,  ///< which particles may be near breaking
  stress_check,  ///< stress and failure in those
  splitting,     ///< cracks, and the contacts of the pieces
  elsewhere      ///< observers, measurement, and what the caller does between steps
};
inline constexpr std::size_t step_part_count = 8;

[[nodiscard]] constexpr const char* to_text(StepPart part) {
  constexpr std::array<const char*, step_part_count> names{
      "integration",  "broad phase",  "narrow phase", "contact law",
      "stress bound", "stress check", "splitting",    "elsewhere"};
  return names[static_cast<std::size_t>(part)];
}

/// Stands for a clock where nobody measures; free.
struct NoLaps {
  void operator()(StepPart) const {}
};

}  // namespace riprap
