// SPDX-License-Identifier: BSL-1.0
#include <riprap/core/ids.hpp>

#include <doctest/doctest.h>
#include <limits>
#include <type_traits>

using namespace riprap;

TEST_CASE("no particle is the last id that counting would reach") {
  CHECK(no_particle == std::numeric_limits<ParticleId>::max());
  CHECK(static_cast<ParticleId>(no_particle + 1) == 0);
}

TEST_CASE("ids and indices are unsigned and of the same width on every platform") {
  CHECK(std::is_unsigned_v<ParticleId>);
  CHECK(std::is_unsigned_v<BodyIndex>);
  CHECK(sizeof(ParticleId) == 4);
  CHECK(sizeof(BodyIndex) == 4);
}
