// SPDX-License-Identifier: BSL-1.0
#include <riprap/geometry/corner_edge_feature.hpp>

#include <doctest/doctest.h>

#include <support/rectangle.hpp>

using namespace riprap;
using test::rectangle;

TEST_CASE("a place has the neighbours of the vertices inside and the vertex opposite to the edge") {
  const CornerEdgeFeature one = corner_edge_feature(4, 3, 5, 0, 1);
  CHECK(one.one_vertex());
  CHECK(one.edge == 3);
  CHECK(one.edge_end == 0);
  CHECK(one.opposite == 2);  // of a square's last edge, from vertex 3 to 0, the others are 1 and 2
  CHECK(one.first == 0);
  CHECK(one.last == 0);
  CHECK(one.before == 4);
  CHECK(one.after == 1);

  const CornerEdgeFeature two = corner_edge_feature(3, 0, 5, 4, 2);
  CHECK(!two.one_vertex());
  CHECK(two.opposite == 2);  // a triangle has no other
  CHECK(two.first == 4);
  CHECK(two.last == 0);
  CHECK(two.before == 3);
  CHECK(two.after == 1);
}

TEST_CASE("the vertex across is none of the edge's") {
  for (std::size_t n = 3; n <= 64; ++n)
    for (std::size_t edge = 0; edge < n; ++edge) {
      const CornerEdgeFeature place = corner_edge_feature(n, edge, 3, 0, 1);
      CHECK(place.opposite < n);
      CHECK(place.opposite != place.edge);
      CHECK(place.opposite != place.edge_end);
    }
}

TEST_CASE("a place fits rings of its sizes only") {
  const ConvexPolygon square = rectangle({0, 0}, 1, 1);
  const ConvexPolygon triangle{{0, 0}, {1, 0}, {0, 1}};
  const CornerEdgeFeature place = corner_edge_feature(4, 0, 3, 0, 1);
  CHECK(place.fits(square.ring(), triangle.ring()));
  CHECK(!place.fits(triangle.ring(), square.ring()));
  CHECK(!place.fits(square.ring(), square.ring()));
  CHECK(!CornerEdgeFeature{}.fits(square.ring(), triangle.ring()));
}
