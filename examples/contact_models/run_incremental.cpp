// SPDX-License-Identifier: BSL-1.0
#include "run.hpp"

namespace contact_models {

Result run_incremental(const Setup& setup) {
  return run(riprap::Model{}
                 .narrow_phase(riprap::OverlapChord{})
                 .contact_law(riprap::IncrementalSpring{})
                 .time_step(riprap::MassFloor{.fraction = 0.12}),
             setup);
}

}  // namespace contact_models
