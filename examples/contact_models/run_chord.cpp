// SPDX-License-Identifier: BSL-1.0
#include "run.hpp"

namespace contact_models {

Result run_chord(const Setup& setup) {
  return run(riprap::Model{}
                 .narrow_phase(riprap::OverlapChord{})
                 .contact_law(riprap::LinearSpringCoulomb{})
                 .time_step(riprap::MassFloor{.fraction = 0.12}),
             setup);
}

}  // namespace contact_models
