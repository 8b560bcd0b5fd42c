// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/splitter/no_split.hpp>

#include <doctest/doctest.h>

#include <riprap/dynamics/boundary/no_boundary.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/crushing.hpp>

using namespace riprap;

TEST_CASE("a particle that would break stays whole where nothing splits") {
  const auto model = Model{}.boundary(NoBoundary{});
  Simulation breaking{model, test::square_between_platens(0.2), Rock{}};
  while (breaking.breaks().empty()) breaking.step();
  Simulation whole{model.splitter(NoSplit{}), test::square_between_platens(0.2), Rock{}};
  while (whole.steps() < 2 * breaking.steps()) whole.step();
  CHECK(whole.breaks().empty());
  CHECK(whole.particles().size() == 3);
  CHECK(whole.failed_ratios()[0] > FailedElementRatio{}.critical);
}
