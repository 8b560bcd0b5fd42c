// SPDX-License-Identifier: BSL-1.0
#include <riprap/particle/ancestry.hpp>

#include <doctest/doctest.h>
#include <type_traits>

using namespace riprap;

TEST_CASE("the default ancestry has no id, no parent, no root and generation 0") {
  const Ancestry none;
  CHECK(none.id == no_particle);
  CHECK(none.parent == no_particle);
  CHECK(none.root == no_particle);
  CHECK(none.generation == 0);
}

TEST_CASE("descent is plain data that outlives the particle") {
  CHECK(std::is_trivially_copyable_v<Ancestry>);
  CHECK(std::is_aggregate_v<Ancestry>);
}
