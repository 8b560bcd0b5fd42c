// SPDX-License-Identifier: BSL-1.0
#include <riprap/experiment/brazilian_test.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <riprap/breakage/line_fit/loaded_diameter.hpp>
#include <riprap/breakage/trigger/brazilian_strength.hpp>
#include <riprap/breakage/trigger/hertzian_strength.hpp>
#include <riprap/breakage/trigger/mean_stress_failure.hpp>
#include <riprap/breakage/trigger/never_breaks.hpp>
#include <riprap/breakage/trigger/tsoungui_strength.hpp>
#include <riprap/breakage/trigger/with_weibull_strength.hpp>
#include <riprap/simulation/model.hpp>
#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

// Area of a regular polygon over that of the circle through its corners.
double area_share(unsigned sides) {
  const double angle = 2 * std::numbers::pi / sides;
  return std::sin(angle) / angle;
}

}  // namespace

TEST_CASE("triggers by the loads have the Brazilian strengths of their equations") {
  for (const BrazilianTest& test : {BrazilianTest{}, BrazilianTest{.diameter = 0.1, .sides = 64}}) {
    const auto strength = [&](const auto& trigger) {
      return test.strength(Model{}.trigger(trigger), Rock{});
    };
    const double share = area_share(test.sides);
    CHECK(strength(BrazilianStrength{5e6}) == near_relative(5e6, 2e-9));
    // Mean stresses are over the area of the polygon.
    CHECK(strength(TsounguiStrength{5e6}) == near_relative(5e6 * share, 2e-9));
    CHECK(strength(MeanStressFailure{}) == near_relative(0.5 * 300e6 * share, 2e-9));
    const double modulus = 70e9 / (2 * (1 - 0.17 * 0.17));
    CHECK(strength(HertzianStrength{}) ==
          near_relative(658e6 * 658e6 / modulus * std::sqrt(share), 2e-9));
    CHECK(strength(WithWeibullStrength{BrazilianStrength{5e6}}) == near_relative(5e6, 2e-9));
  }
}

TEST_CASE("by elements it grows in proportion to the strength of the criterion, at any size") {
  const auto strength = [](double compressive, const BrazilianTest& test) {
    return test.strength(Model{}.criterion(HoekBrown{.compressive_strength = compressive}), Rock{});
  };
  const double of_rock = strength(300e6, {});
  CHECK(of_rock > 12e6);  // not before the middle fails, where 2 F / (pi D t) is the tension
  CHECK(of_rock < 300e6);
  CHECK(strength(60e6, {}) == near_relative(0.2 * of_rock, 1e-8));
  CHECK(strength(300e6, {.diameter = 1.6, .thickness = 0.4}) == near_relative(of_rock, 1e-8));
}

TEST_CASE("what never breaks has no strength, and rules are checked") {
  CHECK(std::isinf(BrazilianTest{}.strength(Model{}.trigger(NeverBreaks{}), Rock{})));
  CHECK_THROWS_WITH_AS(BrazilianTest{.sides = 25}.validate(),
                       "BrazilianTest.sides = 25: must be an even number of 4 to 64", InvalidInput);
  CHECK_THROWS_AS(BrazilianTest{.diameter = 0}.validate(), InvalidInput);
}
