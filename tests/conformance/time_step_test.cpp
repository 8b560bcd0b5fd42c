// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <support/violated.hpp>

#include <riprap/conformance/time_step.hpp>
#include <riprap/dynamics/time_step/fixed_time_step.hpp>
#include <riprap/dynamics/time_step/mass_floor.hpp>
#include <riprap/dynamics/time_step/no_mass_scaling.hpp>

using namespace riprap;
using test::check_violated;

namespace {

struct GivenStep {
  double seconds = 1e-6;
  double time_step(double /*mass*/, double /*stiffness*/) const { return seconds; }
  double mass_scaling(double mass, double smallest) const { return std::max(1.0, smallest / mass); }
  void validate() const {}
};

/// Makes heavy bodies light instead of light ones heavy.
struct UpsideDown : MassFloor {
  double mass_scaling(double mass, double smallest) const { return smallest / mass; }
};

}  // namespace

TEST_CASE("the time-step rules of riprap obey the axioms") {
  CHECK(to_text(time_step_violations(MassFloor{})) == "");
  CHECK(to_text(time_step_violations(NoMassScaling{})) == "");
}

TEST_CASE("FixedTimeStep obeys the axioms where the step that it is given is short enough") {
  CHECK(to_text(time_step_violations(FixedTimeStep{})) == "");
  const Violations too_long = time_step_violations(FixedTimeStep{.seconds = 5e-5});
  check_violated(too_long, "the smallest intact particle on a contact's spring is stable");
  CHECK(too_long.size() == 1);
}

TEST_CASE("a user's time-step rule obeys the axioms for the mass and stiffness it is meant for") {
  CHECK(to_text(time_step_violations(GivenStep{})) == "");
  check_violated(time_step_violations(GivenStep{}, 4e-6, 2e7 * 1e6),
                 "the smallest intact particle on a contact's spring is stable");
}

TEST_CASE("a time-step rule that cannot work is reported") {
  check_violated(time_step_violations(GivenStep{.seconds = 0}), "the time step is above zero");
  check_violated(time_step_violations(GivenStep{.seconds = std::nan("")}),
                 "the time step is above zero");
  check_violated(time_step_violations(MassFloor{.fraction = 2.1}),
                 "the smallest intact particle on a contact's spring is stable");
  check_violated(time_step_violations(UpsideDown{}), "no body is made lighter");
}
