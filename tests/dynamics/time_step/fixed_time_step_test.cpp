// SPDX-License-Identifier: BSL-1.0
#include <riprap/dynamics/time_step/fixed_time_step.hpp>

#include <doctest/doctest.h>

#include <limits>

#include <riprap/simulation/simulation.hpp>
#include <support/crushing.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near_relative;

TEST_CASE("a fixed time step is the same for every mass and stiffness, and makes nothing heavier") {
  const FixedTimeStep rule{.seconds = 3e-6};
  CHECK(rule.time_step(1, 2) == 3e-6);
  CHECK(rule.time_step(1e-9, 1e12) == 3e-6);
  CHECK(rule.mass_scaling(1e-9, 1) == 1);
}

TEST_CASE("a simulation takes the fixed time step, also where a body is freed") {
  Simulation sim{Model{}.time_step(FixedTimeStep{.seconds = 3e-7}),
                 test::square_between_platens(0.1), Rock{}};
  CHECK(sim.time_step() == 3e-7);
  sim.set_motion(1, Motion::free);
  CHECK(sim.time_step() == 3e-7);
  for (int i = 0; i < 4; ++i) sim.step();
  CHECK(sim.time() == near_relative(1.2e-6, 1e-15));
}

TEST_CASE("a fixed time step that is not positive is refused by name") {
  CHECK_NOTHROW(FixedTimeStep{}.validate());
  CHECK(test::message_of([] { FixedTimeStep{0}.validate(); }) ==
        "FixedTimeStep.seconds = 0: must be a finite number above 0");
  CHECK(test::message_of([] {
          FixedTimeStep{std::numeric_limits<double>::infinity()}.validate();
        }) == "FixedTimeStep.seconds = inf: must be a finite number above 0");
}
