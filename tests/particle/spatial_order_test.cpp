// SPDX-License-Identifier: BSL-1.0
#include <riprap/particle/spatial_order.hpp>

#include <doctest/doctest.h>

#include <vector>

#include <riprap/core/random.hpp>

using namespace riprap;

namespace {

PlacedParticle square_at(const Vec2& at) {
  return {ConvexPolygon{at, at + Vec2{1, 0}, at + Vec2{1, 1}, at + Vec2{0, 1}}};
}

}  // namespace

TEST_CASE("the curve goes through a square of four by four cells in Z") {
  const std::uint64_t expected[4][4] = {
      {0, 1, 4, 5}, {2, 3, 6, 7}, {8, 9, 12, 13}, {10, 11, 14, 15}};
  for (std::uint32_t row = 0; row < 4; ++row)
    for (std::uint32_t column = 0; column < 4; ++column)
      CHECK(internal::morton_code(column, row) == expected[row][column]);
}

TEST_CASE("sorted particles are the same ones, and neighbours in the list lie near each other") {
  Random random(1);
  std::vector<PlacedParticle> particles;
  for (int i = 0; i < 4096; ++i)
    particles.push_back(square_at({random.uniform(-50, 50), random.uniform(-50, 50)}));
  const auto sum = [&] {
    Vec2 s{0, 0};
    for (const PlacedParticle& p : particles) s += p.polygon[0];
    return s;
  };
  const auto mean_way = [&] {
    double way = 0;
    for (std::size_t i = 1; i < particles.size(); ++i)
      way += (particles[i].polygon[0] - particles[i - 1].polygon[0]).norm();
    return way / 4095;
  };
  const Vec2 before = sum();
  const double way_before = mean_way();
  sort_by_morton_code(particles);
  CHECK(particles.size() == 4096);
  CHECK((sum() - before).norm() <= 1e-9);  // round-off of 4096 sums of up to 5e4
  // Two random points of the square are 52 apart on average, neighbours of a grid of 64 by 64
  // 1.6; the curve's jumps add to that.
  CHECK(way_before > 40);
  CHECK(mean_way() < 4);
}

TEST_CASE("one particle, or none, or all in one place are no difficulty") {
  std::vector<PlacedParticle> none;
  sort_by_morton_code(none);
  std::vector<PlacedParticle> alike{square_at({1, 1}), square_at({1, 1})};
  sort_by_morton_code(alike);
  CHECK(alike[0].polygon[0] == Vec2{1, 1});
}
