// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/narrow_phase/edge_moments.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include <riprap/contact/narrow_phase/polygon_moments.hpp>
#include <riprap/core/random.hpp>
#include <support/contact_geometry.hpp>
#include <support/rectangle.hpp>

using namespace riprap;
using test::check_moments;
using test::rectangle;
using test::same_bits;

namespace {

const ConvexPolygon floor_below = rectangle({0, -1}, 4, 2);

// A corner or a face with its first vertices below the floor's upper edge.
ConvexPolygon entering(Random& random, bool face) {
  const double depth = random.uniform(0.01, 0.3);
  const double x = random.uniform(-0.5, 0.5);
  const Vec2 right{x + random.uniform(0.4, 0.8), random.uniform(0.5, 0.9)};
  const Vec2 left{x - random.uniform(0.4, 0.8), random.uniform(0.5, 0.9)};
  if (!face) return {{x, -depth}, right, left};
  return {{x - 0.2, -depth}, {x + 0.2, -random.uniform(0.01, 0.3)}, right, left};
}

}  // namespace

TEST_CASE("the closed form at an edge has the moments of the clipped overlap") {
  Random random(5);
  for (int i = 0; i < 400; ++i) {
    const bool face = i % 2 != 0;
    const ConvexPolygon b = entering(random, face);
    const auto feature = corner_edge_feature(4, 2, b.size(), 0, face ? 2 : 1);
    const auto contact =
        corner_edge_overlap<internal::EdgeMoments>(floor_below.ring(), b.ring(), feature);
    REQUIRE(contact);
    const PolygonMoments m = polygon_moments(overlap(floor_below.ring(), b.ring(), {0, 0}, 0));
    // Round-off of coordinates of size 2, over the least depth of 0.01.
    check_moments(*contact, m, 1e-13);
  }
}

TEST_CASE("moments evaluated together are those evaluated one by one, to the last bit") {
  Random random(6);
  for (int i = 0; i < 200; ++i) {
    std::array<ConvexPolygon, 4> bodies{entering(random, false), entering(random, true),
                                        entering(random, true), entering(random, false)};
    std::array<CornerEdgeFeature, 4> features;
    std::array<CornerEdgeQuery, 4> queries;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t count = k == 1 || k == 2 ? 2 : 1;
      features[k] = corner_edge_feature(4, 2, bodies[k].size(), 0, count);
      queries[k] = {floor_below.ring().data(), bodies[k].ring().data(), &features[k]};
    }
    int found = 0;
    const auto compare = [&](std::size_t k, const ContactGeometry& contact) {
      ++found;
      const auto single = corner_edge_overlap<internal::EdgeMoments>(floor_below.ring(),
                                                                     bodies[k].ring(), features[k]);
      REQUIRE(single);
      CHECK(same_bits(contact, *single));
    };
    find_corner_edge_overlaps<2, internal::EdgeMoments>(queries, compare);
    find_corner_edge_overlaps<native_lanes, internal::EdgeMoments>(queries, compare);
    CHECK(found == 8);
  }
}
