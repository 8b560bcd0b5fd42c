// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <riprap/experiment/pressure_servo.hpp>
#include <support/near.hpp>

using namespace riprap;
using riprap::test::near;
using riprap::test::near_relative;

namespace {

constexpr double stiffness = 6e8;    // [Pa]
constexpr double response = 2.5e-3;  // [s]
constexpr double no_limit = std::numeric_limits<double>::infinity();

/// A sample that is the spring the servo takes it for: d sigma/dt = stiffness * rate + drift.
/// The shortfall of the stress after each step, over `duration` [in units of the response].
struct SpringSample {
  double shortfall = 0;  ///< at the start [Pa]
  double drift = 0;      ///< stress that the sample loses by itself [Pa/s]
  double factor = 1;     ///< true stiffness over that assumed
  double largest_rate = no_limit;
  double time_step = 1e-3 * response;

  [[nodiscard]] std::vector<double> run(double duration) const {
    PressureServo servo(stiffness, response, largest_rate);
    std::vector<double> history;
    double e = shortfall;
    for (int n = 0; n < std::lround(duration * response / time_step); ++n) {
      const double rate = servo.rate(e, time_step);
      if (std::abs(rate) > largest_rate) FAIL("rate ", rate, " at step ", n);
      e += time_step * (drift - factor * stiffness * rate);
      history.push_back(e);
    }
    return history;
  }
};

double lowest(const std::vector<double>& history) {
  return *std::min_element(history.begin(), history.end());
}

double largest(const std::vector<double>& history) {
  return *std::max_element(history.begin(), history.end());
}

int sign_changes(const std::vector<double>& history) {
  int changes = 0;
  for (std::size_t i = 1; i < history.size(); ++i) changes += history[i - 1] * history[i] < 0;
  return changes;
}

}  // namespace

TEST_CASE("a stress that is too low shortens the sample, one too high lengthens it") {
  PressureServo low(stiffness, response, no_limit);
  CHECK(low.rate(1e5, 1e-6) > 0);
  PressureServo high(stiffness, response, no_limit);
  CHECK(high.rate(-1e5, 1e-6) < 0);
  PressureServo right(stiffness, response, no_limit);
  CHECK(right.rate(0, 1e-6) == 0);
}

TEST_CASE("a sample at rest is brought to the pressure by a critically damped loop") {
  // e'' + e'/T + e/(4 T^2) = 0 with e(0) = E, e'(0) = -E/T: e = E (1 - u) exp(-u), u = t/(2 T).
  const double start = 2e6;
  const auto history = SpringSample{.shortfall = start}.run(20);
  for (std::size_t n = 0; n < history.size(); ++n) {
    const double u = 0.5e-3 * static_cast<double>(n + 1);
    // First order in the time step, which is 1/1000 of the response.
    CHECK(history[n] == near(start * (1 - u) * std::exp(-u), 1e-3 * start));
  }
  // A double real root passes the target once; u = 2 is the largest overshoot, exp(-2).
  CHECK(sign_changes(history) == 1);
  CHECK(lowest(history) == near(-std::exp(-2.0) * start, 1e-3 * start));
}

TEST_CASE("the loop's distance from its closed form halves with the time step") {
  const auto error = [](double share) {
    const auto history =
        SpringSample{.shortfall = 1, .time_step = share * response}.run(2);  // until u = 1
    return std::abs(history.back());
  };
  // First order: a ratio of 2, but for terms of second order.
  CHECK(error(2e-3) / error(1e-3) == near(2, 0.02));
}

TEST_CASE("a steady drift is compensated without error, and without overshoot on the way") {
  // e(0) = 0, e'(0) = D: e = D t exp(-t / (2 T)), of one sign, largest at t = 2 T.
  const double drift = 1e8;
  const auto history = SpringSample{.drift = drift}.run(60);
  CHECK(lowest(history) >= 0);
  CHECK(largest(history) == near(2 * drift * response / std::exp(1.0), 1e-3 * drift * response));
  // 60 responses are 30 time constants: 60 exp(-30) of D T = 6e-12.
  CHECK(history.back() == near(0, 1e-11 * drift * response));
}

TEST_CASE("without its integral part the servo would drift by D T: that is what it removes") {
  const double drift = 1e8;
  PressureServo servo(stiffness, response, no_limit);
  // At the shortfall of the proportional servo's steady state the first rate balances the drift,
  // but for the integral of a billionth of a response, over four.
  const double steady = drift * response;
  CHECK(stiffness * servo.rate(steady, 1e-9 * response) == near_relative(drift, 1e-9));
}

TEST_CASE("a sample of another stiffness is held as well, only less evenly") {
  // T s^2 + f s + f / (4 T) = 0: damping ratio sqrt(f); stable for every f > 0.
  for (const double factor : {0.1, 0.5, 2.0, 10.0}) {
    CAPTURE(factor);
    const auto history = SpringSample{.shortfall = 1e6, .drift = 1e8, .factor = factor}.run(400);
    CHECK(history.back() == near(0, 1.0));
    // Softer than assumed it swings, stiffer it creeps.
    if (factor < 1) CHECK(sign_changes(history) > 1);
    if (factor > 1) CHECK(lowest(history) > -std::exp(-2.0) * 1e6);
  }
}

TEST_CASE("the rate never passes its limit, in either direction") {
  PressureServo servo(stiffness, response, 0.02);
  CHECK(servo.rate(1e12, 1e-6) == 0.02);
  CHECK(servo.rate(-1e12, 1e-6) == -0.02);
  CHECK(servo.rate(std::numeric_limits<double>::infinity(), 1e-6) == 0.02);
  // Below the limit it is not touched.
  const double small = 0.01 * stiffness * response;
  CHECK(servo.rate(small, 1e-12) == near_relative(0.01, 1e-9));
}

TEST_CASE("the calls at the limit are counted, in both directions") {
  PressureServo servo(stiffness, response, 0.02);
  CHECK(servo.saturated() == 0);
  for (const double shortfall : {1e12, 1e3, -1e12, 0.0, -1e3, 1e12})
    static_cast<void>(servo.rate(shortfall, 1e-6));
  CHECK(servo.saturated() == 3);
}

TEST_CASE("a long time at the limit does not change the integral") {
  PressureServo servo(stiffness, response, 0.02);
  for (int n = 0; n < 1000; ++n) CHECK(servo.rate(1e9, 1e-6) == 0.02);
  CHECK(servo.rate(0, 1e-6) == 0);
  for (int n = 0; n < 1000; ++n) CHECK(servo.rate(-1e9, 1e-6) == -0.02);
  CHECK(servo.rate(0, 1e-6) == 0);
}

TEST_CASE("the value of the integral is kept through a time at the limit") {
  PressureServo servo(stiffness, response, 0.02);
  const double small = 0.001 * stiffness * response;
  for (int n = 0; n < 1000; ++n) static_cast<void>(servo.rate(small, 1e-3 * response));
  // A quarter of the proportional rate for every response of time: 0.001 / 4 after one.
  const double learnt = servo.rate(0, 1e-6);
  CHECK(learnt == near_relative(0.00025, 1e-12));
  for (int n = 0; n < 1000; ++n) static_cast<void>(servo.rate(1e9, 1e-6));
  CHECK(servo.rate(0, 1e-6) == learnt);
}

TEST_CASE("from however far, a limited approach overshoots no more than the last of it would") {
  const double limit = 0.02;
  // Here the proportional part alone is at the limit: from here on the loop is the critical one.
  const double released = limit * stiffness * response;
  for (const double far : {2.0, 20.0, 200.0}) {
    CAPTURE(far);
    const auto history =
        SpringSample{.shortfall = far * released, .largest_rate = limit}.run(far + 20);
    // A per mille for the time step, as above.
    CHECK(lowest(history) == near(-std::exp(-2.0) * released, 1e-3 * released));
    CHECK(history.back() == near(0, 1e-3 * released));
    CHECK(sign_changes(history) == 1);
  }
}

TEST_CASE("in other units of time and stress the servo does the same") {
  PressureServo servo(stiffness, response, 0.02);
  PressureServo scaled(stiffness * 1e-6, response * 1e3, 0.02 * 1e-3);
  for (int n = 0; n < 100; ++n) {
    const double shortfall = 4e4 * std::cos(0.1 * n);
    // A rate in 1/s against one in 1/ms; a handful of roundings in each step.
    CHECK(1e3 * scaled.rate(1e-6 * shortfall, 1e3 * 1e-5) ==
          near(servo.rate(shortfall, 1e-5), 1e-14));
  }
}
