// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/trigger/never_breaks.hpp>

#include <doctest/doctest.h>

#include <riprap/breakage/criterion/never_fails.hpp>

using namespace riprap;

// Elements are still evaluated, so that Rat can be watched: unlike NeverFails it is no criterion.
static_assert(!Criterion<NeverBreaks>);

TEST_CASE("not even a particle all of whose elements have failed breaks") {
  CHECK_FALSE(NeverBreaks{}({.elements = 100, .failed = 100, .lowest_safety_factor = 1e-9}));
}

TEST_CASE("more are needed than there are") {
  CHECK(NeverBreaks{}.failed_elements_needed(100) == 101);
}
