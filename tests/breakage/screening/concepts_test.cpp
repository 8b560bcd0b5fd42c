// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/screening/concepts.hpp>

#include <doctest/doctest.h>

#include <riprap/breakage/screening/evaluate_all.hpp>
#include <riprap/simulation/model_parts.hpp>

using namespace riprap;

TEST_CASE("a screening has a state for the parts of a model") {
  CHECK(Screening<EvaluateAll>);
  CHECK(requirements::ScreeningState<EvaluateAll, BreakageModel<>, StressModel<>>);
  CHECK(requirements::ScreeningState<DefaultScreening, BreakageModel<>, StressModel<>>);
  CHECK_FALSE(Screening<int>);
}
