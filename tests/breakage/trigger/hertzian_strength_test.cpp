// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/trigger/hertzian_strength.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <riprap/breakage/line_fit/loaded_diameter.hpp>
#include <riprap/conformance/acceleration.hpp>
#include <support/loaded_disc.hpp>
#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

TEST_CASE("the largest force decides: its pressure is that on the half-width of Hertz's contact") {
  const Rock rock;  // that of a LoadedSample
  const double modulus = rock.young / (2 * (1 - rock.poisson * rock.poisson));
  const double radius = 0.5 * LoadedDisc::diameter * std::sqrt(LoadedDisc::area_share());
  const double force = 30e3;
  // a^2 = 4 F R / (pi t E*), and the mean pressure is pi / 4 of the largest.
  const double half_width = std::sqrt(4 * force * radius / (pi * LoadedDisc::thickness * modulus));
  const double pressure = force / (2 * half_width * LoadedDisc::thickness) * 4 / pi;
  const auto disc = LoadedDisc::under({{0, 0.2 * force}, {2, force}, {4, 0.9 * force}});
  CHECK(ask(HertzianStrength{(1 - 1e-12) * pressure}, disc) == FailureMode::shear);
  CHECK(ask(HertzianStrength{(1 + 1e-12) * pressure}, disc) == FailureMode::intact);
}

TEST_CASE("in a Brazilian test the tension is the pressure squared over the modulus, at any size") {
  const Rock rock;
  const double modulus = rock.young / (2 * (1 - rock.poisson * rock.poisson));
  const HertzianStrength trigger;
  const double tension = trigger.pressure * trigger.pressure / modulus;
  CHECK(tension == near_relative(12e6, 2e-3));  // of the default rock
  // The radius is that of the area.
  const double force = tension / LoadedDisc::tension(1) * std::sqrt(LoadedDisc::area_share());
  for (const double scale : {0.1, 1.0, 30.0}) {
    const auto mode = [&](double f) {
      return ask(trigger, LoadedDisc::under({{0, f}, {pi, f}}).moved({}, scale, {0, 0}));
    };
    CHECK(mode((1 + 1e-9) * force) == FailureMode::shear);
    CHECK(mode((1 - 1e-9) * force) == FailureMode::intact);
  }
}

TEST_CASE("the pressure must be a positive number") {
  CHECK_THROWS_WITH_AS(HertzianStrength{-1}.validate(),
                       "HertzianStrength.pressure = -1: must be a finite number above 0",
                       InvalidInput);
  CHECK_THROWS_AS(HertzianStrength{std::nan("")}.validate(), InvalidInput);
}

TEST_CASE("results are the same without acceleration") {
  const auto model = Model{}.trigger(HertzianStrength{}).line_fit(LoadedDiameter{});
  Simulation sim{model.boundary(NoBoundary{}), internal::closing_platens(), Rock{}};
  for (int step = 0; step < 1200; ++step) sim.step();
  CHECK(sim.breaks().size() > 5);
  CHECK(to_text(acceleration_violations(model)) == "");
}
