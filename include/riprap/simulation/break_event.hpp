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
  double time = 0;        ///< [s]
  Ancestry particle;      ///< the one that broke
  FailureCount failures;  ///< of the evaluation that broke it; no elements if none are needed
  FailureMode mode = FailureMode::intact;  ///< of the first failed element, or by the trigger
  Line line;                               ///< the crack, in laboratory coordinates
  std::array<ParticleId, 2> pieces{no_particle, no_particle};  ///< left, right; no_particle: dust
  std::array<double, 2> areas{0, 0};                           ///< [m^2]
  std::array<Vec2, 2> centroids{Vec2{0, 0}, Vec2{0, 0}};       ///< laboratory coordinates [m]
  double crack_length = 0;  ///< [m]; times the thickness, the area of the crack

  /// Centroid of the particle that broke [m].
  [[nodiscard]] Vec2 place() const {
    return (areas[0] * centroids[0] + areas[1] * centroids[1]) / (areas[0] + areas[1]);
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("step", self.step);
    visit("time", self.time);
    visit("particle", self.particle);
    visit("failures", self.failures);
    visit("mode", self.mode);
    visit("line", self.line);
    visit("pieces", self.pieces);
    visit("areas", self.areas);
    visit("centroids", self.centroids);
    visit("crack_length", self.crack_length);
  }
};

}  // namespace riprap
