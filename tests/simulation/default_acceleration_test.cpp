// SPDX-License-Identifier: BSL-1.0
#include <riprap/simulation/default_acceleration.hpp>

#include <concepts>

#include <doctest/doctest.h>

#include <riprap/simulation/simulation.hpp>

using namespace riprap;

TEST_CASE("defaults accelerate, or do nothing where the folder of acceleration is not there") {
#if __has_include(<riprap/acceleration/operator_cache.hpp>)
  CHECK_FALSE(std::same_as<DefaultScreening, EvaluateAll>);
  CHECK(DefaultNeighbourList::uses_skin);
#else
  CHECK(std::same_as<DefaultScreening, EvaluateAll>);
  CHECK_FALSE(DefaultNeighbourList::uses_skin);
#endif
  const auto plain = Model{}.without_acceleration().acceleration_model;
  CHECK(std::same_as<decltype(plain.screening), EvaluateAll>);
}
