// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/pair_index.hpp>

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
      std::vector<std::uint32_t> expected;
      for (std::uint32_t k = 0; k < pairs.size(); ++k) {
        if (pairs[k].a == i) expected.push_back(2 * k);
        if (pairs[k].b == i) expected.push_back(2 * k + 1);
      }
      const auto found = index.of(i);
      CHECK(std::vector<std::uint32_t>(found.begin(), found.end()) == expected);
    }
  }
}

TEST_CASE("without pairs no body has a side") {
  PairIndex index;
  index.build(std::vector<Pair>{}, 3);
  for (BodyIndex i = 0; i < 3; ++i) CHECK(index.of(i).empty());
}
