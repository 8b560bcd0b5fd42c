// SPDX-License-Identifier: BSL-1.0
#include <riprap/simulation/default_acceleration.hpp>

#include <doctest/doctest.h>

#include <riprap/simulation/simulation.hpp>

using namespace riprap;

TEST_CASE("defaults accelerate, or do nothing where the folder of acceleration is not there") {
#if __has_include(<riprap/acceleration/operator_cache.hpp>)
  CHECK(DefaultScreening::skips_particles);
  CHECK(DefaultNeighbourList::uses_skin);
#else
  CHECK_FALSE(DefaultScreening::skips_particles);
  CHECK_FALSE(DefaultNeighbourList::uses_skin);
#endif
  CHECK_FALSE(
      decltype(Model{}.without_acceleration().acceleration_model)().screening.skips_particles);
}
