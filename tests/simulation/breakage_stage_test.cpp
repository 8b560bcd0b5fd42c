// SPDX-License-Identifier: BSL-1.0
#include <riprap/simulation/breakage_stage.hpp>

#include <doctest/doctest.h>

#include <type_traits>

#include <riprap/simulation/model.hpp>
#include <support/breakage_passes.hpp>

using namespace riprap;
using namespace riprap::test;

TEST_CASE("a criterion that never fails leaves nothing to keep") {
  const auto model = Model{}.criterion(NeverFails{});
  using Stage = BreakageStage<std::remove_const_t<decltype(model)>>;
  CHECK(std::is_empty_v<Stage>);
  CHECK(Stage(model).operator_bytes() == 0);
  CHECK(Stage(model).find_operator(0) == nullptr);
}

TEST_CASE("operators are known after a pass, until their particle breaks") {
  const Model model;
  const Simulation sim{model, crushed, Rock{}};
  Pass pass(model);
  CHECK(pass.stage.find_operator(0) == nullptr);
  CHECK(pass.find(sim).size() == 2);
  CHECK(pass.stage.find_operator(0) != nullptr);
  CHECK(pass.stage.operator_bytes() > 100'000);
  pass.stage.forget(0);
  CHECK(pass.stage.find_operator(0) == nullptr);
}

TEST_CASE("a particle that has broken into too many pieces is an error") {
  const auto model = Model{}.splitter(StraightCut{.maximum_pieces = 1});
  const Simulation sim{model, crushed, Rock{}};
  Pass pass(model);
  CHECK_THROWS_AS((void)pass.find(sim), SimulationError);
}
