// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/trigger/brazilian_strength.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <riprap/breakage/line_fit/loaded_diameter.hpp>
#include <riprap/conformance/acceleration.hpp>
#include <support/loaded_disc.hpp>

using namespace riprap;
using namespace riprap::test;

TEST_CASE("a disc splits at the force of its Brazilian strength, whatever else presses it") {
  const BrazilianStrength trigger{.strength = 10e6};
  const double force = 10e6 / LoadedDisc::tension(1);
  for (const double beside : {0.0, 0.5 * force, 0.999 * force}) {
    const auto mode = [&](double f) {
      return ask(trigger,
                 LoadedDisc::under({{0, f}, {pi, f}, {0.5 * pi, beside}, {1.5 * pi, beside}}));
    };
    CHECK(mode((1 + 1e-12) * force) == FailureMode::tension);
    CHECK(mode((1 - 1e-12) * force) == FailureMode::intact);
  }
}

TEST_CASE("the distance of the points counts: a slab between its broad faces is weaker") {
  internal::LoadedSample slab{rectangle(0.04, 0.01), 0.01, {}};
  const BrazilianStrength trigger{.strength = 10e6};
  const auto mode = [&](const Vec2& arm, double force) {
    slab.loads = {{.arm_lab = arm, .force_lab = -force * arm.normalized()},
                  {.arm_lab = -arm, .force_lab = force * arm.normalized()}};
    return ask(trigger, slab);
  };
  const double force = 10e6 * 0.5 * pi * 0.01 * 0.01;
  CHECK(mode({0, 0.005}, 1.001 * force) == FailureMode::tension);
  CHECK(mode({0, 0.005}, 0.999 * force) == FailureMode::intact);
  CHECK(mode({0.02, 0}, 4.004 * force) == FailureMode::tension);
  CHECK(mode({0.02, 0}, 3.996 * force) == FailureMode::intact);
}

TEST_CASE("a particle on one contact does not break") {
  CHECK(ask(BrazilianStrength{}, LoadedDisc::under({{0, 1e12}})) == FailureMode::intact);
}

TEST_CASE("the strength must be a positive number") {
  CHECK_THROWS_WITH_AS(BrazilianStrength{0}.validate(),
                       "BrazilianStrength.strength = 0: must be a finite number above 0",
                       InvalidInput);
  CHECK_THROWS_AS(BrazilianStrength{std::nan("")}.validate(), InvalidInput);
}

TEST_CASE("results are the same without acceleration") {
  const auto model = Model{}.trigger(BrazilianStrength{}).line_fit(LoadedDiameter{});
  Simulation sim{model.boundary(NoBoundary{}), internal::closing_platens(), Rock{}};
  for (int step = 0; step < 1200; ++step) sim.step();
  CHECK(sim.breaks().size() > 5);
  CHECK(to_text(acceleration_violations(model)) == "");
}
