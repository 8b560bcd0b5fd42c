// SPDX-License-Identifier: BSL-1.0
#pragma once
// The models that the options stand for.

#include "policies.hpp"

// What all programs share.
inline auto breakable_model(const Options& o) {
  return riprap::Model{}
      .broad_phase(o.broad_phase)
      .contact_law(o.energy_conserving)
      .damping(o.damping)
      .time_step(o.time_step)
      .criterion(chosen_criterion(o))
      .line_fit(chosen_line_fit(o))
      .plane_state(chosen_plane(o))
      .mesher(o.mesher)
      .trigger(o.failed_elements)
      .splitter(o.splitter)
      .check_every(o.check_every)
      .execution(AnyExecution{static_cast<int>(o.threads)});
}

// The same with a choice of contact, integrator and support, and of scatter of the strengths.
inline auto model_of_choices(const Options& o) {
  return breakable_model(o)
      .narrow_phase(chosen_narrow_phase(o))
      .contact_law(chosen_contact(o))
      .time_step(chosen_time_step(o))
      .integrator(chosen_integrator(o))
      .trigger(chosen_element_trigger(o))
      .support(chosen_support(o));
}

// The same with breakage by the contact loads alone: no particle is meshed.
inline auto model_by_loads(const Options& o) {
  return model_of_choices(o).trigger(chosen_load_trigger(o)).line_fit(chosen_load_line_fit(o));
}
