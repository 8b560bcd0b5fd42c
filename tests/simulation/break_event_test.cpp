// SPDX-License-Identifier: BSL-1.0
#include <riprap/simulation/break_event.hpp>

#include <doctest/doctest.h>

using namespace riprap;

TEST_CASE("a record of a break begins without particle, failed elements and pieces") {
  const BreakEvent event{};
  CHECK(event.particle.id == no_particle);
  CHECK(event.failures.ratio() == 0);
  CHECK(event.mode == FailureMode::intact);
  CHECK(event.pieces[0] == no_particle);
  CHECK(event.pieces[1] == no_particle);
  CHECK(event.areas[0] + event.areas[1] == 0);
}
