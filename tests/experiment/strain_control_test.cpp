// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <riprap/experiment/strain_control.hpp>
#include <support/loading_scene.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near_relative;

TEST_CASE("a rate is given, or that of an inertial number at a pressure") {
  const test::LoadingScene view{.confining_pressure = 4e6};
  CHECK(LoadingRate{.per_second = -0.25}.value(view) == -0.25);
  CHECK(LoadingRate{.inertial_number = 1e-3}.value(view) == near_relative(2, 1e-15));
  CHECK(LoadingRate{.inertial_number = 1e-3, .pressure = 1e6}.value(view) ==
        near_relative(1, 1e-15));
  CHECK((-LoadingRate{.inertial_number = 1e-3}).value(view) == near_relative(-2, 1e-15));
  CHECK_THROWS_WITH_AS(
      LoadingRate{}.validate("axis"),
      "axis.inertial_number = 0: must be other than 0, or per_second must, and not both",
      InvalidInput);
  CHECK_THROWS_AS((LoadingRate{.inertial_number = 1, .per_second = 1}.validate("axis")),
                  InvalidInput);
}

TEST_CASE("engineering strain grows evenly, logarithmic strain does so in its own measure") {
  test::LoadingScene view{.sim = {.step = 1e-5}};
  EngineeringRate engineering{.rate_of_strain = {.per_second = 0.5}, .smooth = false};
  LogarithmicRate logarithmic{.rate_of_strain = {.per_second = 0.5}, .smooth = false};
  engineering.begin(view, 1);
  logarithmic.begin(view, 2);
  for (int n = 0; n < 100'000; ++n) {
    const Vec2 rate{engineering.rate(view, 1), logarithmic.rate(view, 2)};
    view.stretch -= view.sim.step * componentwise_product(rate, view.stretch);
  }
  // After 1 s. Round-off of 1e5 steps, and the first-order error of log(1 - x), x = 5e-6 a step.
  CHECK(view.strain(1) == near_relative(0.5, 1e-11));
  CHECK(view.stretch.y() == near_relative(std::exp(-0.5), 2e-6));
}

TEST_CASE("a smooth rate is reached in the time of the servo's response") {
  test::LoadingScene view;
  EngineeringRate control{.rate_of_strain = {.per_second = 2}};
  control.begin(view, 2);
  view.time = 1.25e-3 - view.sim.step;
  CHECK(control.rate(view, 2) == near_relative(1, 1e-12));
  view.time = 1;
  CHECK(control.rate(view, 2) == 2);
}

TEST_CASE("fixed means no rate, constant volume that a step leaves the area as it is") {
  const test::LoadingScene view{.sim = {.step = 1e-3}};
  CHECK(Fixed{}.rate(view, 1) == 0);
  for (const double other : {0.0, 0.3, -20.0, 300.0}) {
    const double rate = ConstantVolume{}.rate(view, 1, other);
    // Round-off of two factors.
    CHECK((1 - 1e-3 * rate) * (1 - 1e-3 * other) == near_relative(1, 4e-16));
  }
}
