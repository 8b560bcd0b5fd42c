// SPDX-License-Identifier: BSL-1.0
#include <riprap/geometry/entry_place.hpp>

#include <doctest/doctest.h>

#include <support/rectangle.hpp>

using namespace riprap;
using test::rectangle;

TEST_CASE(
    "a place knows the neighbours of the vertices inside and the vertex opposite to the edge") {
  const EntryPlace one = entry_place(4, 3, 5, 0, 1);
  CHECK(one.one_vertex());
  CHECK(one.edge == 3);
  CHECK(one.edge_end == 0);
  CHECK(one.across == 2);  // of a square's last edge, from vertex 3 to 0, the others are 1 and 2
  CHECK(one.first == 0);
  CHECK(one.last == 0);
  CHECK(one.before == 4);
  CHECK(one.after == 1);

  const EntryPlace two = entry_place(3, 0, 5, 4, 2);
  CHECK(!two.one_vertex());
  CHECK(two.across == 2);  // a triangle has no other
  CHECK(two.first == 4);
  CHECK(two.last == 0);
  CHECK(two.before == 3);
  CHECK(two.after == 1);
}

TEST_CASE("the vertex across is none of the edge's") {
  for (std::size_t n = 3; n <= 64; ++n)
    for (std::size_t edge = 0; edge < n; ++edge) {
      const EntryPlace place = entry_place(n, edge, 3, 0, 1);
      CHECK(place.across < n);
      CHECK(place.across != place.edge);
      CHECK(place.across != place.edge_end);
    }
}

TEST_CASE("a place fits rings of its sizes only") {
  const ConvexPolygon square = rectangle({0, 0}, 1, 1);
  const ConvexPolygon triangle{{0, 0}, {1, 0}, {0, 1}};
  const EntryPlace place = entry_place(4, 0, 3, 0, 1);
  CHECK(place.fits(square.ring(), triangle.ring()));
  CHECK(!place.fits(triangle.ring(), square.ring()));
  CHECK(!place.fits(square.ring(), square.ring()));
  CHECK(!EntryPlace{}.fits(square.ring(), triangle.ring()));
}
