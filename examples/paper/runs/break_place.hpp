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
  riprap::Vec2 centroid{0, 0};
  for (riprap::BodyIndex i = 0; i < particles.size(); ++i)
    for (std::size_t k = 0; k < 2; ++k)
      if (particles.ancestry(i).id == event.pieces[k])
        centroid += event.areas[k] / (event.areas[0] + event.areas[1]) * particles.body(i).position;
  return centroid.cwiseQuotient(view.stretch);
}

}  // namespace study
