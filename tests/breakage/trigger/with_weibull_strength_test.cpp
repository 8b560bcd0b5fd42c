// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/trigger/with_weibull_strength.hpp>

#include <cmath>
#include <doctest/doctest.h>

#include <riprap/breakage/line_fit/loaded_diameter.hpp>
#include <riprap/breakage/trigger/brazilian_strength.hpp>
#include <riprap/breakage/trigger/failed_area_ratio.hpp>
#include <riprap/breakage/trigger/failed_element_ratio.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/breakage_passes.hpp>
#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

static_assert(LoadTrigger<WithWeibullStrength<BrazilianStrength>>);
static_assert(HasStrengthFactor<WithWeibullStrength<BrazilianStrength>>);
static_assert(ScreenableTrigger<WithWeibullStrength<FailedElementRatio>>);
static_assert(ScreenableTrigger<WithWeibullStrength<FailedAreaRatio>>);
static_assert(!ScreenableTrigger<WithWeibullStrength<BrazilianStrength>>);

}  // namespace

TEST_CASE("of the failed-element ratio it is WeibullStrength") {
  const WithWeibullStrength<FailedElementRatio> with{.trigger = {0.3}, .modulus = 3, .seed = 7};
  const WeibullStrength weibull{.modulus = 3, .critical = 0.3, .seed = 7};
  for (const ParticleId id : {0u, 5u, 77u})
    CHECK(with.strength_factor(id, 1e-4) == weibull.strength_factor(id, 1e-4));
  const WithWeibullStrength<FailedElementRatio> by_volume{.modulus = 3, .dimension = 3};
  // An eighth of the reference area: 8^(1.5 / 3) in place of 8^(1 / 3), of the same draw.
  CHECK(by_volume.strength_factor(7, 2e-4 / 8) / by_volume.strength_factor(7, 2e-4) ==
        near_relative(std::sqrt(8.0), 1e-14));
  for (const std::size_t failed : {29u, 30u})
    CHECK(with(FailureCount{.elements = 100, .failed = failed}) ==
          weibull(FailureCount{.elements = 100, .failed = failed}));
  CHECK(with.failed_elements_needed(100) == 30);
  CHECK(WithWeibullStrength{FailedAreaRatio{0.2}}.failed_area_needed() ==
        FailedAreaRatio{0.2}.failed_area_needed());
}

TEST_CASE("a particle breaks at its strength factor times the force of the mean one") {
  const auto breaks = [](const auto& trigger) {
    const auto model = Model{}.trigger(trigger).line_fit(LoadedDiameter{});
    const Simulation sim{model, crushed, Rock{}};
    Pass pass(model);
    std::vector<BodyIndex> broken;
    for (const auto& [i, crack] : pass.find(sim)) broken.push_back(i);
    return broken;
  };
  // The strength at which particle 0 just breaks.
  double low = 1e6;
  double high = 1e12;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (breaks(BrazilianStrength{middle}).empty() ? high : low) = middle;
  }
  const WithWeibullStrength<BrazilianStrength> weibull{.modulus = 2};
  const double factor = weibull.strength_factor(0, 0.016 * 0.016);
  const auto has_zero = [&](double strength) {
    auto trigger = weibull;
    trigger.trigger.strength = strength;
    const auto broken = breaks(trigger);
    return std::find(broken.begin(), broken.end(), 0u) != broken.end();
  };
  CHECK(std::abs(factor - 1) > 0.1);
  CHECK(has_zero(0.9999 * low / factor));
  CHECK_FALSE(has_zero(1.0001 * low / factor));
}

TEST_CASE("parameters of both are checked") {
  CHECK_THROWS_AS(WithWeibullStrength{BrazilianStrength{0}}.validate(), InvalidInput);
  CHECK_THROWS_WITH_AS((WithWeibullStrength<BrazilianStrength>{.modulus = 0}.validate()),
                       "WeibullStrength.modulus = 0: must be a number above 0", InvalidInput);
  CHECK_NOTHROW(WithWeibullStrength{BrazilianStrength{}}.validate());
}
