// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/narrow_phase/no_overlap.hpp>

#include <doctest/doctest.h>

#include <support/rectangle.hpp>

using namespace riprap;

TEST_CASE("nobody touches where nothing overlaps, not even a body on top of itself") {
  const ConvexPolygon square = test::rectangle({0, 0}, 1, 1);
  NoOverlap::Memory memory;
  CHECK(!NoOverlap{}(square.ring(), square.ring(), memory));
}
