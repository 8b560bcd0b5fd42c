// SPDX-License-Identifier: BSL-1.0
#include <riprap/core/scope_exit.hpp>

#include <doctest/doctest.h>

#include <stdexcept>

TEST_CASE("the action runs once when the scope is left, by an exception too") {
  int runs = 0;
  {
    const riprap::internal::ScopeExit exit([&] { ++runs; });
    CHECK(runs == 0);
  }
  CHECK(runs == 1);
  try {
    const riprap::internal::ScopeExit exit([&] { ++runs; });
    throw std::runtime_error("left");
  } catch (const std::runtime_error&) {
    CHECK(runs == 2);
  }
}
