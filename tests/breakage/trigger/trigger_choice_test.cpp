// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/trigger/trigger_choice.hpp>

#include <doctest/doctest.h>

#include <riprap/breakage/trigger/brazilian_strength.hpp>
#include <riprap/breakage/trigger/mean_stress_failure.hpp>
#include <riprap/breakage/trigger/tsoungui_strength.hpp>
#include <riprap/breakage/trigger/with_weibull_strength.hpp>
#include <support/loaded_disc.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

using Choice = TriggerChoice<BrazilianStrength, MeanStressFailure, TsounguiStrength>;
static_assert(LoadTrigger<Choice>);

// A choice would hide the strengths of the trigger in it; around it they stay.
template <class... T>
concept Choosable = requires { typename TriggerChoice<T...>; };
static_assert(Choosable<BrazilianStrength>);
static_assert(!Choosable<BrazilianStrength, WithWeibullStrength<BrazilianStrength>>);
static_assert(HasStrengthFactor<WithWeibullStrength<Choice>>);
static_assert(LoadTrigger<WithWeibullStrength<Choice>>);

}  // namespace

TEST_CASE("a chosen trigger decides as the trigger itself") {
  const auto check = [](const auto& trigger) {
    for (const internal::LoadedSample& unit : internal::loaded_samples(0.016, 10))
      for (double force = 100; force < 1e7; force *= 2)
        CHECK(ask(Choice{trigger}, unit.times(force)) == ask(trigger, unit.times(force)));
  };
  check(BrazilianStrength{});
  check(MeanStressFailure{});
  check(TsounguiStrength{});
}

TEST_CASE("its parameters are checked") {
  CHECK_THROWS_AS(Choice{BrazilianStrength{0}}.validate(), InvalidInput);
  CHECK_NOTHROW(Choice{MeanStressFailure{}}.validate());
}
