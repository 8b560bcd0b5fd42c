// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/trigger/mean_stress_failure.hpp>

#include <doctest/doctest.h>

#include <riprap/breakage/criterion/mohr_coulomb.hpp>
#include <riprap/breakage/line_fit/mean_stress_failure_plane.hpp>
#include <riprap/conformance/acceleration.hpp>
#include <support/loaded_disc.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

// A square of 20 mm, 10 mm thick, under normal stresses on its faces.
internal::LoadedSample square_under(double s11, double s22) {
  internal::LoadedSample sample{rectangle(0.02, 0.02), 0.01, {}};
  for (const double side : {1.0, -1.0}) {
    sample.loads.push_back(
        {.arm_lab = {0.01 * side, 0}, .force_lab = {-side * s11 * 0.02 * 0.01, 0}});
    sample.loads.push_back(
        {.arm_lab = {0, 0.01 * side}, .force_lab = {0, -side * s22 * 0.02 * 0.01}});
  }
  return sample;
}

}  // namespace

TEST_CASE("a uniform stress fails where the criterion of the model has its strength") {
  const HoekBrown criterion;  // that of a LoadedSample
  const MeanStressFailure trigger;
  for (const double minor : {0.0, 5e6, 80e6}) {
    const double major = criterion.major_stress_at_failure(minor);
    CHECK(ask(trigger, square_under(minor, 1.0001 * major)) == FailureMode::shear);
    CHECK(ask(trigger, square_under(minor, 0.9999 * major)) == FailureMode::intact);
    CHECK(ask(trigger, square_under(1.0001 * major, minor)) == FailureMode::shear);
  }
  const double tension = criterion.tensile_strength();
  CHECK(ask(trigger, square_under(-1.0001 * tension, 0)) == FailureMode::tension);
  // Closer to it sigma_1f is below zero.
  CHECK(ask(trigger, square_under(-0.99 * tension, 0)) == FailureMode::intact);
}

TEST_CASE("without loads, and under equal stresses, nothing fails") {
  CHECK(ask(MeanStressFailure{}, square_under(0, 0)) == FailureMode::intact);
  CHECK(ask(MeanStressFailure{}, square_under(1e12, 1e12)) == FailureMode::intact);
}

TEST_CASE("a disc between two forces fails at its uniaxial strength, for it has no mean tension") {
  const double strength = HoekBrown{}.major_stress_at_failure(0);
  // F D / (A t).
  const double force = strength * 0.25 * pi * LoadedDisc::diameter * LoadedDisc::thickness *
                       LoadedDisc::area_share();
  const auto mode = [](double f) {
    return ask(MeanStressFailure{}, LoadedDisc::under({{0, f}, {pi, f}}));
  };
  CHECK(mode((1 + 1e-9) * force) == FailureMode::shear);
  CHECK(mode((1 - 1e-9) * force) == FailureMode::intact);
}

TEST_CASE("results are the same without acceleration, by the criterion that the model has") {
  const auto model = Model{}
                         .criterion(MohrCoulomb{.cohesion = 4e6, .angle = 0.7, .tension = 2e6})
                         .trigger(MeanStressFailure{})
                         .line_fit(MeanStressFailurePlane{});
  Simulation sim{model.boundary(NoBoundary{}), internal::closing_platens(), Rock{}};
  for (int step = 0; step < 1200; ++step) sim.step();
  CHECK(sim.breaks().size() > 5);
  CHECK(to_text(acceleration_violations(model)) == "");
}
