// SPDX-License-Identifier: BSL-1.0
#pragma once
// Where a particle was that has just broken.

#include <riprap/experiment/stage.hpp>
#include <riprap/simulation/break_event.hpp>

namespace study {

// The centroid of its pieces, before the field of the stage began to move it [m].
template <class Sim>
riprap::Vec2 break_place(const riprap::BiaxialView<Sim>& view, const riprap::BreakEvent& event) {
  const auto& particles = view.sim.particles();
  riprap::Vec2 sum{0, 0};
  double area = 0;
  for (riprap::BodyIndex i = 0; i < particles.size(); ++i)
    for (std::size_t k = 0; k < 2; ++k)
      if (particles.ancestry(i).id == event.pieces[k]) {
        sum += event.areas[k] * particles.body(i).position;
        area += event.areas[k];
      }
  return (sum / area).cwiseQuotient(view.stretch);
}

}  // namespace study
