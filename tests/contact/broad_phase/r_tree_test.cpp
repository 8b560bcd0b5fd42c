// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <doctest/doctest.h>
#include <utility>
#include <vector>

#include <riprap/contact/broad_phase/all_pairs.hpp>
#include <riprap/contact/broad_phase/r_tree.hpp>
#include <riprap/core/random.hpp>

using namespace riprap;

namespace {

using Pairs = std::vector<std::pair<BodyIndex, BodyIndex>>;

template <BroadPhase Broad>
Pairs pairs_of(const std::vector<Box>& boxes) {
  Pairs pairs;
  Broad{}.visit_pairs(std::span<const Box>(boxes),
                      [&](BodyIndex i, BodyIndex j) { pairs.emplace_back(i, j); });
  return pairs;
}

std::vector<Box> random_boxes(std::uint64_t seed, double smallest, double largest) {
  Random random(seed);
  std::vector<Box> boxes;
  for (int i = 0; i < 300; ++i) {
    const Vec2 low{random.uniform(-1, 1), random.uniform(-1, 1)};
    boxes.push_back(
        {low, low + Vec2{random.uniform(smallest, largest), random.uniform(smallest, largest)}});
  }
  return boxes;
}

}  // namespace

TEST_CASE("the tree finds just the pairs that brute force finds, each once and i before j") {
  for (const auto& [smallest, largest] :
       {std::pair{0.01, 0.02}, std::pair{0.01, 1.0}, std::pair{0.0, 0.0}, std::pair{2.0, 3.0}}) {
    const auto boxes = random_boxes(1, smallest, largest);
    Pairs found = pairs_of<RTree>(boxes);
    std::sort(found.begin(), found.end());
    CHECK(found == pairs_of<AllPairs>(boxes));
  }
}

TEST_CASE("boxes that coincide or lie far apart are found by the tree") {
  std::vector<Box> boxes(5, Box{{0, 0}, {1, 1}});
  boxes.push_back({{1e9, 0}, {1e9 + 1, 1}});
  boxes.push_back({{-1e9, -1e9}, {1e9, 1e9}});
  boxes.push_back({{1, 1}, {2, 2}});  // meets the others in one point
  Pairs found = pairs_of<RTree>(boxes);
  std::sort(found.begin(), found.end());
  CHECK(found == pairs_of<AllPairs>(boxes));
}

TEST_CASE("the order of the tree's pairs depends on the boxes only") {
  const auto boxes = random_boxes(3, 0.1, 0.3);
  CHECK(pairs_of<RTree>(boxes) == pairs_of<RTree>(boxes));
}

TEST_CASE("a negative skin is refused by name, for a tree") {
  CHECK_NOTHROW(RTree{.relative_skin = 0}.validate());
  CHECK_THROWS_WITH_AS(RTree{.relative_skin = -0.1}.validate(),
                       "RTree.relative_skin = -0.1: must be a finite number, 0 or above",
                       InvalidInput);
}
