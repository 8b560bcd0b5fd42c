// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/trigger/failed_element_ratio.hpp>

#include <doctest/doctest.h>

#include <cmath>

using namespace riprap;

TEST_CASE("a particle breaks when Rat reaches RatF") {
  const FailedElementRatio trigger;  // 0.4
  CHECK(trigger({.elements = 100, .failed = 40}));
  CHECK(trigger({.elements = 5, .failed = 2}));
  CHECK(trigger({.elements = 95, .failed = 95}));
  CHECK_FALSE(trigger({.elements = 100, .failed = 39}));
  CHECK_FALSE(trigger({.elements = 103, .failed = 41}));
}

TEST_CASE("a particle without failed elements never breaks") {
  CHECK_FALSE(FailedElementRatio{}({.elements = 100, .failed = 0}));
  CHECK_FALSE(FailedElementRatio{.critical = 1e-300}({.elements = 100, .failed = 0}));
  CHECK_FALSE(FailedElementRatio{}({.elements = 0, .failed = 0}));
}

TEST_CASE("with RatF above one nothing breaks") {
  CHECK_FALSE(FailedElementRatio{.critical = 1.01}({.elements = 10, .failed = 10}));
  CHECK_NOTHROW(FailedElementRatio{.critical = 1.01}.validate());
}

TEST_CASE("RatF must be a positive number") {
  CHECK_THROWS_WITH_AS(FailedElementRatio{.critical = 0}.validate(),
                       "FailedElementRatio.critical = 0: must be a finite number above 0",
                       InvalidInput);
  CHECK_THROWS_AS(FailedElementRatio{.critical = std::nan("")}.validate(), InvalidInput);
}

TEST_CASE("two fifths of the elements are needed, rounded up; above one there are never enough") {
  CHECK(FailedElementRatio{}.failed_elements_needed(100) == 40);
  CHECK(FailedElementRatio{}.failed_elements_needed(103) == 42);
  CHECK(FailedElementRatio{}.failed_elements_needed(0) == 1);
  CHECK(FailedElementRatio{.critical = 1.01}.failed_elements_needed(10) == 11);
}
