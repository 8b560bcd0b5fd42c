// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <riprap/experiment/crossing_condition.hpp>
#include <riprap/experiment/end_combination.hpp>
#include <support/loading_scene.hpp>
#include <support/near.hpp>
#include <variant>

using namespace riprap;
using test::near;

TEST_CASE("a strain is reached from below or from above, from where the stage begins") {
  test::LoadingScene view;
  StrainReached up{.strain = 0.1};
  StrainReached down{.strain = -0.1};
  up.begin(view);
  down.begin(view);
  view.stretch.y() = 0.95;
  CHECK(!up.reached(view));
  CHECK(!down.reached(view));
  CHECK(up.done(view) == near(0.5, 1e-14));
  CHECK(down.done(view) == near(-0.5, 1e-14));
  view.stretch.y() = 0.875;
  CHECK(up.reached(view));
  view.stretch.y() = 1.125;
  CHECK(down.reached(view));
  CHECK(!up.reached(view));
}

TEST_CASE("a target where the stage begins is reached at once") {
  const test::LoadingScene view;
  StrainReached none{.strain = 0};
  none.begin(view);
  CHECK(none.reached(view));
}

TEST_CASE("strains of either axis and of the volume, stresses, their mean and difference") {
  test::LoadingScene view;
  view.stretch = {0.5, 0.75};
  view.state = {.s11 = 1e6, .s22 = 4e6};
  const auto crosses = [&](auto condition) {
    condition.begin(test::LoadingScene{});
    return condition.reached(view);
  };
  // Just reached, just not.
  CHECK(crosses(StrainReached{0.4999, StrainOf::axis_1}));
  CHECK(!crosses(StrainReached{0.5001, StrainOf::axis_1}));
  CHECK(crosses(StrainReached{0.2499, StrainOf::axis_2}));
  CHECK(!crosses(StrainReached{0.2501, StrainOf::axis_2}));
  CHECK(crosses(StrainReached{0.6249, StrainOf::volume}));
  CHECK(!crosses(StrainReached{0.6251, StrainOf::volume}));
  CHECK(crosses(StressReached{0.99e6, StressOf::axis_1}));
  CHECK(!crosses(StressReached{1.01e6, StressOf::axis_1}));
  CHECK(crosses(StressReached{3.99e6, StressOf::axis_2}));
  CHECK(!crosses(StressReached{4.01e6, StressOf::axis_2}));
  CHECK(crosses(StressReached{2.49e6, StressOf::mean}));
  CHECK(!crosses(StressReached{2.51e6, StressOf::mean}));
  CHECK(crosses(StressReached{2.99e6, StressOf::difference}));
  CHECK(!crosses(StressReached{3.01e6, StressOf::difference}));
}

TEST_CASE("any of several conditions, all of several") {
  test::LoadingScene view;
  using One = std::variant<StepsMade, StrainReached>;
  const One strain = StrainReached{.strain = 0.1};
  const One steps = StepsMade{.steps = 7};
  AnyOf<One> any{{.parts = {strain, steps}}};
  AllOf<One> all{{.parts = {strain, steps}}};
  any.begin(view);
  all.begin(view);
  CHECK(!any.reached(view));
  view.stage_steps = 7;
  CHECK(any.reached(view));
  CHECK(!all.reached(view));
  CHECK(any.done(view) == 1);
  CHECK(all.done(view) == 0);
  view.stretch.y() = 0.875;
  CHECK(all.reached(view));
  CHECK_THROWS_AS((AnyOf<One>{}.validate("end")), InvalidInput);
}
