// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/trigger/tsoungui_strength.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <riprap/breakage/line_fit/mean_stress_line.hpp>
#include <riprap/conformance/acceleration.hpp>
#include <riprap/stress/element/constant_strain_triangle.hpp>
#include <riprap/stress/influence_operator.hpp>
#include <riprap/stress/plane_state/plane_stress.hpp>
#include <support/brazilian_disc.hpp>
#include <support/loaded_disc.hpp>
#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

// Strength at which a disc just breaks, of the circle: mean stresses go with 1 / area.
double tension_of(const std::vector<RadialForce>& forces) {
  const auto disc = LoadedDisc::under(forces);
  double low = 0;
  double high = 1e12;
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    (ask(TsounguiStrength{middle}, disc) == FailureMode::tension ? low : high) = middle;
  }
  return low * LoadedDisc::area_share();
}

// Tension in the middle of the disc by finite elements [Pa].
double finite_element_tension(const std::vector<RadialForce>& forces) {
  const UniformMesher mesher{.triangles = 1500};
  const InfluenceOperator op(mesher(LoadedDisc::polygon().ring()), ConstantStrainTriangle{},
                             PlaneStress{}, Rock{}, LoadedDisc::thickness, false);
  ElementStress stress;
  stress.reset(op.sampling_points().size());
  for (const ContactLoad& load : LoadedDisc::under(forces).loads)
    op.add_stress(op.locator().nearest(load.arm_lab).at, load.force_lab, stress);
  return -middle_stress(op.mesh(), stress, 0.05 * LoadedDisc::diameter).principal_values().minor;
}

}  // namespace

TEST_CASE("between two forces it is the Brazilian test") {
  CHECK(tension_of({{0, 900}, {pi, 900}}) == near_relative(LoadedDisc::tension(900), 1e-12));
  CHECK(tension_of({{0.3, 900}, {0.3 + pi, 900}}) ==
        near_relative(LoadedDisc::tension(900), 1e-12));
}

TEST_CASE("two pairs of forces act against each other: the smaller one counts three times") {
  for (const double across : {100.0, 250.0})
    CHECK(tension_of({{0, 900}, {0.5 * pi, across}, {pi, 900}, {1.5 * pi, across}}) ==
          near_relative(LoadedDisc::tension(900 - 3 * across), 1e-12));
}

TEST_CASE("a hydrostatic load breaks nothing, be it of three forces, of four or of seven") {
  for (const int count : {3, 4, 7}) {
    std::vector<RadialForce> forces;
    for (int k = 0; k < count; ++k) forces.push_back({0.1 + 2 * pi * k / count, 1e12});
    CHECK(ask(TsounguiStrength{}, LoadedDisc::under(forces)) == FailureMode::intact);
  }
}

TEST_CASE("it is the tension in the middle by finite elements, of any balanced radial forces") {
  // Balanced by the law of sines.
  const double a = 2.7;
  const double b = 2 * pi - 2.9;
  const std::vector<RadialForce> three{{0, 900},
                                       {a, 900 * std::sin(2 * pi - b) / std::sin(b - a)},
                                       {b, 900 * std::sin(a) / std::sin(b - a)}};
  const std::vector<RadialForce> four{{0, 900}, {pi / 2, 150}, {pi, 900}, {1.5 * pi, 150}};
  for (const auto& forces : {three, four})
    // The mean within a tenth of the radius, and the error of the elements.
    CHECK(finite_element_tension(forces) == near_relative(tension_of(forces), 0.03));
}

TEST_CASE("the strength must be a positive number") {
  CHECK_THROWS_WITH_AS(TsounguiStrength{0}.validate(),
                       "TsounguiStrength.strength = 0: must be a finite number above 0",
                       InvalidInput);
}

TEST_CASE("results are the same without acceleration") {
  const auto model = Model{}.trigger(TsounguiStrength{}).line_fit(MeanStressLine{});
  Simulation sim{model.boundary(NoBoundary{}), internal::closing_platens(), Rock{}};
  for (int step = 0; step < 1200; ++step) sim.step();
  CHECK(sim.breaks().size() > 5);
  CHECK(to_text(acceleration_violations(model)) == "");
}
