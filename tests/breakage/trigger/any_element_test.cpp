// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/trigger/any_element.hpp>

#include <doctest/doctest.h>

using namespace riprap;

TEST_CASE("one failed element breaks the particle, however many elements it has") {
  CHECK(AnyElement{}({.elements = 1000, .failed = 1}));
  CHECK(AnyElement{}({.elements = 3, .failed = 3}));
}

TEST_CASE("a particle without failed elements stays whole") {
  // Not even one that is close to failure.
  CHECK_FALSE(AnyElement{}({.elements = 1000, .failed = 0, .lowest_safety_factor = 1.0001}));
  CHECK_FALSE(AnyElement{}({}));
}

TEST_CASE("one is needed") { CHECK(AnyElement{}.failed_elements_needed(100) == 1); }
