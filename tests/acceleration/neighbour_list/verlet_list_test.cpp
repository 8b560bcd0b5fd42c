// SPDX-License-Identifier: BSL-1.0
#include <riprap/acceleration/neighbour_list/verlet_list.hpp>

#include <doctest/doctest.h>

#include <array>
#include <set>

#include <riprap/contact/broad_phase/all_pairs.hpp>
#include <riprap/contact/broad_phase/uniform_grid.hpp>
#include <riprap/core/random.hpp>
#include <riprap/geometry/separation.hpp>

using namespace riprap;

namespace {

using Pair = std::array<long, 4>;  // a, b and the image of b

ConvexPolygon diamond(const Vec2& centre, double reach) {
  return {centre + Vec2{reach, 0}, centre + Vec2{0, reach}, centre - Vec2{reach, 0},
          centre - Vec2{0, reach}};
}

Particles scattered(unsigned count, double extent, double reach, std::uint64_t seed) {
  Random random(seed);
  Particles particles(1, 1);
  for (unsigned i = 0; i < count; ++i) {
    const double x = random.uniform(-extent, extent);
    particles.add(diamond({x, random.uniform(-extent, extent)}, reach), Motion::free);
  }
  return particles;
}

template <class Broad>
std::set<Pair> found(Broad broad, const Particles& particles, const PeriodicDomain& domain) {
  NeighbourSearch<Broad, PeriodicDomain> search{broad};
  std::set<Pair> pairs;
  search.visit_pairs(particles, domain, [&](BodyIndex a, BodyIndex b, const auto& image) {
    CHECK(a < b);
    CHECK(pairs.insert({a, b, image.axis_1, image.axis_2}).second);  // once
  });
  return pairs;
}

// Every body with every image of every other, box by box.
std::set<Pair> by_brute_force(const Particles& particles, const PeriodicDomain& domain,
                              double reach) {
  std::set<Pair> pairs;
  const auto count = static_cast<BodyIndex>(particles.size());
  for (BodyIndex a = 0; a < count; ++a)
    for (BodyIndex b = a + 1; b < count; ++b)
      for (int i = -6; i <= 6; ++i)
        for (int j = -6; j <= 6; ++j) {
          const Vec2 between =
              particles.body(b).position + domain.offset({i, j}) - particles.body(a).position;
          if (between.cwiseAbs().maxCoeff() <= 2 * reach) pairs.insert({a, b, i, j});
        }
  return pairs;
}

}  // namespace

TEST_CASE("in a periodic plane every body meets every image that is near, once") {
  const PeriodicDomain domain{.period = {1, 1.3}};
  // Bodies need not lie in the cell: these are spread over several copies of it.
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const Particles particles = scattered(60, 1.5, 0.05, seed);
    const std::set<Pair> expected = by_brute_force(particles, domain, 0.05);
    REQUIRE(expected.size() > 20);
    CHECK(found(AllPairs{.relative_skin = 0}, particles, domain) == expected);
    CHECK(found(UniformGrid{.relative_skin = 0}, particles, domain) == expected);
  }
}

TEST_CASE("a body that would meet its own image is an error that names it") {
  Particles particles(1, 1);
  particles.add(diamond({0.3, 0}, 0.6), Motion::free);
  particles.add(diamond({5, 0.5}, 0.1), Motion::free);
  NeighbourSearch<AllPairs, PeriodicDomain> search{AllPairs{}};
  CHECK_THROWS_WITH_AS(
      search.visit_pairs(particles, PeriodicDomain{.period = {1, 4}}, [](auto, auto, auto) {}),
      "particle 0 meets its own image: the periodic cell is too small", SimulationError);
}

namespace {

using PairOfTwo = NeighbourSearch<AllPairs, PeriodicDomain>;

// A tenth of the mean diameter of 0.1 as skin: 0.01.
PairOfTwo searched(const Particles& particles, const PeriodicDomain& domain) {
  PairOfTwo search{AllPairs{.relative_skin = 0.1}};
  search.visit_pairs(particles, domain, [](auto, auto, auto) {});
  return search;
}

}  // namespace

TEST_CASE("the shrinking of the cell makes the pairs stale before any can be missing") {
  Particles particles(1, 1);
  particles.add(diamond({0, 0}, 0.05), Motion::free);
  particles.add(diamond({0.4, 0}, 0.05), Motion::free);
  PeriodicDomain domain{.period = {1, 1}};
  PairOfTwo search = searched(particles, domain);
  CHECK_FALSE(search.stale(particles, domain));
  // An image at rest may come nearer by the skin.
  domain.period = {0.995, 1};
  CHECK_FALSE(search.stale(particles, domain));
  SUBCASE("of itself") {
    domain.period = {0.985, 1};
    CHECK(search.stale(particles, domain));
  }
  SUBCASE("together with what the bodies have used up") {
    particles.body(0).position.x() -= 0.0031;
    CHECK(search.stale(particles, domain));
  }
}

TEST_CASE("pairs are stale when bodies have come or when one asks for it") {
  Particles particles = scattered(5, 1, 0.05, 1);
  const PeriodicDomain domain{.period = {3, 3}};
  PairOfTwo search = searched(particles, domain);
  CHECK_FALSE(search.stale(particles, domain));
  search.invalidate();
  CHECK(search.stale(particles, domain));
  search = searched(particles, domain);
  particles.add(diamond({0, 0}, 0.05), Motion::free);
  CHECK(search.stale(particles, domain));
}
