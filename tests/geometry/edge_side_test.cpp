#include <riprap/geometry/edge_side.hpp>

#include <doctest/doctest.h>

#include <support/rectangle.hpp>

using namespace riprap;
using test::rectangle;

TEST_CASE("vertices lie to an edge at their distances, inwards, times its length") {
  const ConvexPolygon floor = rectangle({0, -1}, 4, 2);  // its upper edge is y = 0
  const ConvexPolygon tip{{0.5, -0.25}, {1, 1}, {-1, 2}};
  const std::size_t upper = 2;
  const EdgeSide side = edge_side(floor.ring(), upper, tip.ring());
  CHECK(side.distances[0] == 0.25 * 4);
  CHECK(side.distances[1] == -1 * 4);
  CHECK(side.distances[2] == -2 * 4);
  CHECK(side.inside == 1);
  CHECK(side.deepest == 1);
  CHECK(side.depth(floor.ring(), upper) == 0.25);
}

TEST_CASE("the deepest of vertices that are all outside tells how far apart the rings are") {
  const ConvexPolygon floor = rectangle({0, -1}, 4, 2);
  const ConvexPolygon above = rectangle({0, 1.5}, 1, 1);
  const EdgeSide side = edge_side(floor.ring(), 2, above.ring());
  CHECK(side.inside == 0);
  CHECK(side.depth(floor.ring(), 2) == -1);
}
