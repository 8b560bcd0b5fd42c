// SPDX-License-Identifier: BSL-1.0
#include "run.hpp"

#include "../run_table/run_biaxial.hpp"

namespace contact_models {

BiaxialNumbers run_incremental(const Setup& setup) {
  return run_table::run_biaxial(riprap::Model{}
                                    .narrow_phase(riprap::OverlapChord{})
                                    .contact_law(riprap::IncrementalSpring{})
                                    .time_step(riprap::MassFloor{.fraction = 0.12}),
                                setup);
}

}  // namespace contact_models
