// SPDX-License-Identifier: BSL-1.0
#include <riprap/experiment/biaxial_result.hpp>

#include <doctest/doctest.h>

using namespace riprap;

TEST_CASE("the result of a stage is found by its name") {
  BiaxialResult result;
  result.stages = {{{.steps = 1}, {.steps = 2}, {.steps = 3}, {.steps = 4}}};
  CHECK(result.stage(Stage::compaction).steps == 1);
  CHECK(result.stage(Stage::relaxation).steps == 2);
  CHECK(result.stage(Stage::hydrostatic).steps == 3);
  CHECK(result.stage(Stage::shear).steps == 4);
}
