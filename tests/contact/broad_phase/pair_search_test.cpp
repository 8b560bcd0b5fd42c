// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/broad_phase/pair_search.hpp>

#include <doctest/doctest.h>

#include <array>
#include <set>
#include <utility>

#include <riprap/contact/broad_phase/all_pairs.hpp>
#include <riprap/contact/broad_phase/uniform_grid.hpp>
#include <support/diamonds.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::diamond;
using test::scattered;

namespace {

using Pair = std::array<long, 4>;  // a, b and the image of b

template <class Broad>
std::set<Pair> found(Broad broad, const Particles& particles, const PeriodicDomain& domain) {
  PairSearch<Broad, PeriodicDomain> search{broad};
  std::set<Pair> pairs;
  search.visit_pairs(particles, domain, true, [&](BodyIndex a, BodyIndex b, const auto& image) {
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
      for (int i = -12; i <= 12; ++i)
        for (int j = -6; j <= 6; ++j) {
          const Vec2 between =
              particles.body(b).position + domain.offset({i, j}) - particles.body(a).position;
          if (between.cwiseAbs().maxCoeff() <= 2 * reach) pairs.insert({a, b, i, j});
        }
  return pairs;
}

}  // namespace

TEST_CASE("in a periodic cell every body is paired once with every image near it") {
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

TEST_CASE("in a sheared cell every body is paired once with every image near it") {
  for (const double offset : {0.2, 0.5, -0.5, 0.97, -1.46, 3.7}) {
    CAPTURE(offset);
    const PeriodicDomain domain{.period = {1, 1.3}, .shear_offset = offset};
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
      // Wide ones, too: those meet images that are almost two periods away in the row above.
      const double reach = seed == 3u ? 0.2 : 0.05;
      const Particles particles = scattered(60, 1.5, reach, seed);
      const std::set<Pair> expected = by_brute_force(particles, domain, reach);
      REQUIRE(expected.size() > 20);
      CHECK(found(AllPairs{.relative_skin = 0}, particles, domain) == expected);
      CHECK(found(UniformGrid{.relative_skin = 0}, particles, domain) == expected);
    }
  }
}

TEST_CASE("a body paired with its own image is an error that names it") {
  Particles particles(1, 1);
  particles.add(diamond({0.3, 0}, 0.6), Motion::free);
  particles.add(diamond({5, 0.5}, 0.1), Motion::free);
  PairSearch<AllPairs, PeriodicDomain> search{AllPairs{}};
  CHECK_THROWS_WITH_AS(search.visit_pairs(particles, PeriodicDomain{.period = {1, 4}}, true,
                                          [](auto, auto, auto) {}),
                       "particle 0 meets its own image: the periodic cell is too small",
                       SimulationError);
}

TEST_CASE("a search with a skin finds gaps up to the skin, one without finds overlapping boxes") {
  // Diamonds of circumradius 0.1: a skin of half of the mean diameter is 0.1.
  Particles particles(1, 1);
  for (const double x : {0.0, 0.19, 0.45, 0.8}) particles.add(diamond({x, 0}, 0.1), Motion::free);
  PairSearch<AllPairs, UnboundedDomain> search{AllPairs{.relative_skin = 0.5}};
  for (const bool with_skin : {true, false}) {
    std::set<std::pair<BodyIndex, BodyIndex>> pairs;
    const PairExtent extent =
        search.visit_pairs(particles, UnboundedDomain{}, with_skin,
                           [&](BodyIndex a, BodyIndex b, UnboundedDomain::Image) {
                             pairs.insert({a, b});
                           });
    CHECK(extent.skin == test::near(with_skin ? 0.1 : 0, 1e-15));
    CHECK(extent.centres == test::near(with_skin ? 0.5 : 0.2, 1e-15));
    CHECK(pairs.count({0, 1}) == 1);
    CHECK(pairs.count({1, 2}) == (with_skin ? 1 : 0));
    CHECK(pairs.count({2, 3}) == 0);
  }
}
