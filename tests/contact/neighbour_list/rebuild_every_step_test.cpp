// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/neighbour_list/rebuild_every_step.hpp>

#include <doctest/doctest.h>

using namespace riprap;

TEST_CASE("the list is stale at every step and no pair is skipped") {
  RebuildEveryStep::State<UnboundedDomain> state;
  const Particles none(1, 1);
  for (int i = 0; i < 3; ++i) {
    CHECK(state.is_stale(none, UnboundedDomain{}, Serial{}));
    state.rebuilt(none, UnboundedDomain{}, PairExtent{.skin = 1});
  }
  CHECK(state.displacement() >= state.contact_threshold(1e300));
}
