// SPDX-License-Identifier: BSL-1.0
#include <riprap/particle/random_placement.hpp>

#include <doctest/doctest.h>

#include <support/message_of.hpp>

using namespace riprap;

TEST_CASE("options that break a rule are refused by name") {
  const auto message = [](const RandomAssembly& options) {
    return test::message_of([&] { options.validate(); });
  };
  CHECK(message({}) == "");
  CHECK(message({.count = 29}) == "RandomAssembly.count = 29: must be 30 or more");
  CHECK(message({.smallest_diameter = 0}) ==
        "RandomAssembly.smallest_diameter = 0: must lie in (0, 1]");
  CHECK(message({.dense_fraction = 0.4}) ==
        "RandomAssembly.dense_fraction = 0.4: must lie above solid_fraction and be at most 1");
  CHECK(message({.diameters = {0.01}}) ==
        "RandomAssembly.diameters.size() = 1: must be 0 or RandomAssembly.count");
}
