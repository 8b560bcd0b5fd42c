// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/narrow_phase/corner_moments.hpp>

#include <doctest/doctest.h>

#include <array>

#include <riprap/contact/narrow_phase/polygon_moments.hpp>
#include <riprap/core/random.hpp>
#include <riprap/geometry/overlap.hpp>
#include <support/contact_geometry.hpp>

using namespace riprap;
using test::check_moments;
using test::same_bits;

namespace {

const ConvexPolygon below{{-1, -1}, {1, -1}, {1, 0}, {-1, 0}};

// Its first vertex lies in the upper right corner of `below`, whose third one lies in it.
ConvexPolygon over_the_end(Random& random) {
  const Vec2 tip{random.uniform(0.5, 0.9), random.uniform(-0.3, -0.02)};
  return {tip, {2.5, random.uniform(-0.02, 0.01) + tip.y()}, {2.5, 1}, {tip.x(), 1}};
}

}  // namespace

TEST_CASE("the closed form of two corners has the moments of the clipped overlap") {
  Random random(5);
  for (int i = 0; i < 300; ++i) {
    const ConvexPolygon b = over_the_end(random);
    const auto contact =
        corner_corner_overlap<internal::CornerMoments>({below.ring(), b.ring(), 2, 0, 1e-8});
    REQUIRE(contact);
    const PolygonMoments m = polygon_moments(overlap(below.ring(), b.ring(), {0, 0}, 0));
    // Round-off of coordinates of size 2, over the least depth of 0.02.
    check_moments(*contact, m, 1e-13);
  }
}

TEST_CASE("corners evaluated together are those evaluated one by one, to the last bit") {
  Random random(6);
  for (int i = 0; i < 100; ++i) {
    const std::array<ConvexPolygon, 4> bodies{over_the_end(random), over_the_end(random),
                                              over_the_end(random), over_the_end(random)};
    std::array<CornerCornerQuery, 4> queries;
    for (std::size_t k = 0; k < 4; ++k) queries[k] = {below.ring(), bodies[k].ring(), 2, 0, 1e-8};
    int found = 0;
    find_corner_corner_overlaps<native_lanes, internal::CornerMoments>(
        queries, [&](std::size_t k, const ContactGeometry& contact) {
          ++found;
          const auto single = corner_corner_overlap<internal::CornerMoments>(queries[k]);
          REQUIRE(single);
          CHECK(same_bits(contact, *single));
        });
    CHECK(found == 4);
  }
}
