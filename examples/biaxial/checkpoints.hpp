// SPDX-License-Identifier: BSL-1.0
#pragma once
// A test that can be stopped and go on.

#include "../command_line/checkpoints.hpp"
#include "options.hpp"

// A checkpoint goes on with the same options, but for the strain that it is to reach.
inline command_line::Saving saving_of(const Options& o) {
  return {.folder = o.out,
          .every = o.checkpoint_every,
          .given = {.toml = o.toml, .free = "strain"},
          .resumed = o.out};
}

// Goes on from the newest checkpoint of the folder. Throws InvalidInput if it has gone past the
// axial strain of the options.
template <class Run, class Sim, class... Observers>
void resume(const Options& o, Run& run, Sim& sim, Observers&... observers) {
  command_line::go_on(saving_of(o), run, sim, observers...);
  if (run.view().stage == riprap::Stage::shear)
    riprap::require(o.test.axial_strain >= run.view().axial_strain(), "BiaxialTest.axial_strain",
                    o.test.axial_strain,
                    "must not be below that of the checkpoint, " +
                        riprap::to_text(run.view().axial_strain()));
}
