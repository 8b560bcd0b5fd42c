// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>
#include <utility>
#include <vector>

#include <riprap/contact/broad_phase/all_pairs.hpp>

using namespace riprap;

TEST_CASE("all pairs of boxes that meet are visited once, in order") {
  const std::vector<Box> boxes{
      {{0, 0}, {1, 1}}, {{5, 5}, {6, 6}}, {{0.5, 0.5}, {2, 2}}, {{-1, -1}, {9, 9}}};
  std::vector<std::pair<BodyIndex, BodyIndex>> pairs;
  AllPairs{}.visit_pairs(std::span<const Box>(boxes),
                         [&](BodyIndex i, BodyIndex j) { pairs.emplace_back(i, j); });
  CHECK(pairs == std::vector<std::pair<BodyIndex, BodyIndex>>{{0, 2}, {0, 3}, {1, 3}, {2, 3}});
}

TEST_CASE("none or one box makes no pair by brute force") {
  const std::vector<Box> one{{{0, 0}, {1, 1}}};
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}})
    AllPairs{}.visit_pairs(std::span<const Box>(one.data(), count),
                           [](BodyIndex, BodyIndex) { FAIL("no pair"); });
}

TEST_CASE("a negative skin is refused by name, for brute force") {
  CHECK_NOTHROW(AllPairs{.relative_skin = 0}.validate());
  CHECK_THROWS_WITH_AS(AllPairs{.relative_skin = -0.1}.validate(),
                       "AllPairs.relative_skin = -0.1: must be a finite number, 0 or above",
                       InvalidInput);
}
