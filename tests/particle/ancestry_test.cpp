// SPDX-License-Identifier: BSL-1.0
#include <riprap/particle/ancestry.hpp>

#include <doctest/doctest.h>
#include <type_traits>

using namespace riprap;

TEST_CASE("nobody has no name, no parent, no root and no past") {
  const Ancestry nobody;
  CHECK(nobody.id == no_particle);
  CHECK(nobody.parent == no_particle);
  CHECK(nobody.root == no_particle);
  CHECK(nobody.generation == 0);
}

TEST_CASE("descent is plain data that outlives the particle") {
  CHECK(std::is_trivially_copyable_v<Ancestry>);
  CHECK(std::is_aggregate_v<Ancestry>);
}
