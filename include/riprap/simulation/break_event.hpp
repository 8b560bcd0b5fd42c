// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The record of one break.

#include <array>
#include <cstdint>

#include <riprap/breakage/failure/failure_count.hpp>
#include <riprap/geometry/cut.hpp>
#include <riprap/particle/ancestry.hpp>

namespace riprap {

/// One particle has become two, or one and dust.
struct BreakEvent {
  std::uint64_t step = 0;
  double time = 0;                         ///< [s]
  Ancestry particle;                       ///< the one that broke
  FailureCount failures;                   ///< of the evaluation that broke it
  FailureMode mode = FailureMode::intact;  ///< of the first failed element
  Line line;                               ///< the crack, in laboratory coordinates
  std::array<ParticleId, 2> pieces{no_particle, no_particle};  ///< left, right; no_particle: dust
  std::array<double, 2> areas{0, 0};                           ///< [m^2]
  double crack_length = 0;  ///< [m]; times the thickness, the area of the crack
};

}  // namespace riprap
