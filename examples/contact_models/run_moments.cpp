// SPDX-License-Identifier: BSL-1.0
#include "run.hpp"

#include "../run_table/run_biaxial.hpp"

namespace contact_models {

// At the time step of the others: its peak stiffness is twice theirs.
BiaxialNumbers run_moments(const Setup& setup) {
  return run_table::run_biaxial(riprap::Model{}
                                    .narrow_phase(riprap::OverlapMoments{})
                                    .contact_law(riprap::EnergyConservingSpring{})
                                    .time_step(riprap::MassFloor{.fraction = 0.17}),
                                setup);
}

}  // namespace contact_models
