// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/narrow_phase/no_overlap.hpp>

#include <doctest/doctest.h>

#include <support/rectangle.hpp>

using namespace riprap;

TEST_CASE("no contact, not even of a body with itself") {
  const ConvexPolygon square = test::rectangle({0, 0}, 1, 1);
  NoOverlap::Cache cache;
  CHECK(!NoOverlap{}(square.ring(), square.ring(), cache));
}
