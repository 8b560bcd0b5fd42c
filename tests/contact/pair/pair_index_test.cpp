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
