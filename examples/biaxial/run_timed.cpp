// SPDX-License-Identifier: BSL-1.0
// As with inertia relief, with a StepTimer: compiled apart, so that the others read no clock.

#include <riprap/measurement/step_timer.hpp>

#include "run.hpp"

Outcome run_timed(const Options& options) {
  riprap::StepTimer timer;
  const Outcome outcome = run(options, breakable_model(options), timer);
  timer.print();
  return outcome;
}
