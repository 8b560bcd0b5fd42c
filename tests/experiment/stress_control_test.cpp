// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <cmath>
#include <riprap/experiment/stress_control.hpp>
#include <support/loading_scene.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near_relative;

namespace {

const ServoControl free_servo{.expected_rate = {.per_second = 1e6}};

// A sample of two springs, which the servo takes for what it is; `push` is the rate of axis 2.
void strain_for(double seconds, test::LoadingScene& view, auto& control, double push = 0) {
  const double stiffness = view.sample_stiffness();
  control.begin(view, 1);
  const double step = view.sim.time_step();
  for (const double begun = view.time; view.time - begun < seconds; view.time += step) {
    view.state.s11 += step * stiffness * control.rate(view, 1);
    view.state.s22 += step * stiffness * push;
  }
}

}  // namespace

TEST_CASE("a stress comes to its value and stays") {
  test::LoadingScene view{.state = {.s11 = 1e6, .s22 = 5e6}};
  ControlledStress control{.stress = 3e6, .control = free_servo};
  // Critically damped, two poles at -1 / (2 response): (1 + t / 2 T) exp(-t / 2 T) at t = 40 T.
  strain_for(0.1, view, control);
  CHECK(view.state.s11 == near_relative(3e6, 1e-6));
}

TEST_CASE("a stress follows its ramp with the lag of the servo, and ends at its value") {
  test::LoadingScene view{.state = {.s11 = 1e6}};
  ControlledStress control{.stress = 3e6, .stress_rate = 1e7, .control = free_servo};
  strain_for(0.1, view, control);
  // At 2 MPa by the ramp. A loop with an integral follows a ramp without error in the long run.
  CHECK(view.state.s11 == near_relative(2e6, 1e-3));
  view.time = 0;
  view.state.s11 = 5e6;
  strain_for(0.3, view, control);
  CHECK(view.state.s11 == near_relative(3e6, 1e-3));
}

TEST_CASE("a free boundary has no stress, a stress ratio follows the other axis") {
  test::LoadingScene view{.state = {.s11 = 1e6, .s22 = 4e6}};
  FreeBoundary none{.control = free_servo};
  strain_for(0.1, view, none);
  CHECK(std::abs(view.state.s11) < 1);
  StressRatio ratio{.ratio = 0.5, .control = free_servo};
  strain_for(0.1, view, ratio, 0.05);
  CHECK(view.state.s22 > 5e6);
  CHECK(view.state.s11 == near_relative(0.5 * view.state.s22, 1e-3));
}

TEST_CASE("the mean stress stays while the other axis is pressed") {
  test::LoadingScene view{.state = {.s11 = 3e6, .s22 = 3e6}};
  ConstantMeanStress control{.stress = 3e6, .control = free_servo};
  strain_for(0.1, view, control, 0.02);
  CHECK(view.state.s22 > 4e6);
  CHECK(view.state.mean() == near_relative(3e6, 1e-3));
}

TEST_CASE("errors are judged where there is a tolerance") {
  TrackingServo servo;
  servo.begin(test::LoadingScene{}, 1);
  for (const double stress : {1.1e6, 0.8e6}) (void)servo.tracked_rate(stress, 1e6, 1e-6);
  CHECK(servo.mean_error() == near_relative(-0.05, 1e-12));
  CHECK(servo.rms_error() == near_relative(std::sqrt(0.5 * (0.01 + 0.04)), 1e-12));
  CHECK(servo.last_error() == near_relative(-0.2, 1e-12));
  ServoControl control{.tolerance = 0.04, .servo = servo};
  CHECK(!control.held());
  control.tolerance = 0.06;
  CHECK(control.held());
  control.tolerance = 0;
  CHECK(control.held());
}

TEST_CASE("the last error is that of any step with a target other than 0") {
  TrackingServo servo;
  servo.begin(test::LoadingScene{}, 1);
  (void)servo.rate(1.3e6, 1e6, 1e-6);
  CHECK(servo.last_error() == near_relative(0.3, 1e-12));
  CHECK(servo.mean_error() == 0);
  (void)servo.rate(-0.5e6, -1e6, 1e-6);
  CHECK(servo.last_error() == near_relative(-0.5, 1e-12));
  (void)servo.rate(1e6, 0, 1e-6);
  CHECK(servo.last_error() == 0);
}

TEST_CASE("the servo's rate has a limit, and saturation is counted") {
  test::LoadingScene view;
  ControlledStress control{.stress = 1e9, .control = {.expected_rate = {.per_second = 0.1}}};
  control.begin(view, 1);
  CHECK(control.rate(view, 1) == near_relative(1.0, 1e-15));  // ten times the expected rate
  CHECK(control.control.servo.saturated() == 1);
}

TEST_CASE("bad values are named") {
  const ServoControl judged{.expected_rate = {.per_second = 1}, .tolerance = 0.1};
  CHECK_THROWS_WITH_AS((ControlledStress{.stress = 0, .control = judged}.validate("a")),
                       "a.stress = 0: must not be 0 where its relative error is judged",
                       InvalidInput);
  CHECK_THROWS_WITH_AS(
      (FreeBoundary{.control = judged}.validate("a")),
      "a.tolerance = 0.1: must be 0: an error relative to no stress has no meaning", InvalidInput);
  CHECK_THROWS_AS((StressRatio{.ratio = 0}.validate("a")), InvalidInput);
  CHECK_THROWS_AS((ConstantMeanStress{.stress = -1}.validate("a")), InvalidInput);
}
