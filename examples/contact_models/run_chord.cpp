// SPDX-License-Identifier: BSL-1.0
#include "run.hpp"

#include "../run_table/run_biaxial.hpp"

namespace contact_models {

BiaxialNumbers run_chord(const Setup& setup) {
  return run_table::run_biaxial(riprap::Model{}
                                    .narrow_phase(riprap::OverlapChord{})
                                    .contact_law(riprap::LinearSpringCoulomb{})
                                    .time_step(riprap::MassFloor{.fraction = 0.12}),
                                setup);
}

}  // namespace contact_models
