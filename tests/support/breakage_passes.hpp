// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Two squares crushed between platens, and a breakage pass over the state of a simulation.

#include <riprap/simulation/breakage_stage.hpp>
#include <riprap/simulation/simulation.hpp>

namespace riprap::test {

inline const ConvexPolygon square{{0, 0}, {0.016, 0}, {0.016, 0.016}, {0, 0.016}};
inline const ConvexPolygon platen{{-0.02, 0}, {0.04, 0}, {0.04, 0.016}, {-0.02, 0.016}};

// Two squares crushed between platens, the one that was added last on the left.
inline const Assembly crushed{.particles = {{square.moved({}, {0.02, 0})},
                                            {platen.moved({}, {0, 0.0150}), Motion::prescribed},
                                            {platen.moved({}, {0, -0.0150}), Motion::prescribed},
                                            {square.moved({}, {-0.015, 0})}}};

// A breakage pass of its own, over the state of any simulation of the model.
template <class ModelType>
struct Pass {
  explicit Pass(const ModelType& m) : model(m) {}

  template <class Sim>
  const BreakagePass::Cracks& find(const Sim& sim) {
    return stage.find_cracks(model, rock, sim.mean_area(), sim.particles(), sim.contacts(),
                             NoPhaseTimer{});
  }

  ModelType model;
  Rock rock{};
  BreakageStage<ModelType> stage{model};
};

}  // namespace riprap::test
