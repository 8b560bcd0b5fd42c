// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/pair/pair_index.hpp>

#include <doctest/doctest.h>

#include <vector>

#include <riprap/core/random.hpp>

using namespace riprap;

namespace {

struct Pair {
  BodyIndex a;
  BodyIndex b;
};

}  // namespace

TEST_CASE("every body has its sides of all pairs, in rising order") {
  Random random(71);
  PairIndex index;
  for (const unsigned bodies : {2U, 50U, 7U}) {
    std::vector<Pair> pairs;
    for (int k = 0; k < 100; ++k) {
      const BodyIndex b = random.uniform_integer(1, bodies - 1);
      pairs.push_back({random.uniform_integer(0, b - 1), b});
    }
    index.build(pairs, bodies + 1);  // the last one has none
    for (BodyIndex i = 0; i <= bodies; ++i) {
      std::vector<PairSide> expected;
      for (std::uint32_t k = 0; k < pairs.size(); ++k) {
        if (pairs[k].a == i) expected.push_back({k, false});
        if (pairs[k].b == i) expected.push_back({k, true});
      }
      const auto found = index.of(i);
      CHECK(std::vector<PairSide>(found.begin(), found.end()) == expected);
    }
  }
}

TEST_CASE("without pairs no body has a side") {
  PairIndex index;
  index.build(std::vector<Pair>{}, 3);
  for (BodyIndex i = 0; i < 3; ++i) CHECK(index.of(i).empty());
}

TEST_CASE("a side has its pair and which body it is") {
  CHECK(PairSide{}.index() == 0);
  CHECK(PairSide(7, false).index() == 14);
  CHECK(PairSide(7, true).index() == 15);
  CHECK(PairSide(7, true).pair() == 7);
  CHECK(PairSide(7, true).is_b());
  CHECK_FALSE(PairSide(7, false).is_b());
}

TEST_CASE("sides that are added follow the others of their body, which may be new") {
  PairIndex index;
  index.build(std::vector<Pair>{{0, 1}, {0, 2}, {1, 2}}, 3);
  const auto of = [&](BodyIndex i) {
    const auto found = index.of(i);
    return std::vector<PairSide>(found.begin(), found.end());
  };
  index.add(4, {3, true});
  index.add(0, {3, false});
  index.add(0, {4, false});
  CHECK(index.size() == 5);
  CHECK(of(0) == std::vector<PairSide>{{0, false}, {1, false}, {3, false}, {4, false}});
  CHECK(of(1) == std::vector<PairSide>{{0, true}, {2, false}});
  CHECK(of(2) == std::vector<PairSide>{{1, true}, {2, true}});
  CHECK(of(3).empty());
  CHECK(of(4) == std::vector<PairSide>{{3, true}});
}
