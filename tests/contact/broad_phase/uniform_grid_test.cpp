// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <doctest/doctest.h>
#include <utility>
#include <vector>

#include <riprap/contact/broad_phase/uniform_grid.hpp>
#include <riprap/core/random.hpp>

using namespace riprap;

namespace {

using Pairs = std::vector<std::pair<BodyIndex, BodyIndex>>;

Pairs found_in(const std::vector<Box>& boxes) {
  Pairs pairs;
  UniformGrid{}.visit_pairs(std::span<const Box>(boxes),
                            [&](BodyIndex i, BodyIndex j) { pairs.emplace_back(i, j); });
  return pairs;
}

/// Compares every box with every other one.
Pairs brute_force(const std::vector<Box>& boxes) {
  Pairs pairs;
  for (BodyIndex i = 0; i < boxes.size(); ++i)
    for (BodyIndex j = i + 1; j < boxes.size(); ++j)
      if (boxes[i].overlaps(boxes[j])) pairs.emplace_back(i, j);
  return pairs;
}

/// The same pairs as by brute force, each once and with i < j.
void check(const std::vector<Box>& boxes) {
  Pairs found = found_in(boxes);
  std::sort(found.begin(), found.end());
  CHECK(found == brute_force(boxes));
}

Box random_box(Random& random, double extent, double size) {
  const Vec2 low{random.uniform(-extent, extent), random.uniform(-extent, extent)};
  return {low, low + Vec2{random.uniform(0.2, 1) * size, random.uniform(0.2, 1) * size}};
}

std::vector<Box> random_boxes(std::uint64_t seed, int count, double extent, double size) {
  Random random(seed);
  std::vector<Box> boxes;
  for (int i = 0; i < count; ++i) boxes.push_back(random_box(random, extent, size));
  return boxes;
}

}  // namespace

TEST_CASE("the grid finds just the pairs that brute force finds, each once") {
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
    for (const double size : {0.01, 0.1, 0.5, 3.0}) {
      CAPTURE(size);
      check(random_boxes(seed, 200, 1, size));
    }
  CHECK(brute_force(random_boxes(1, 200, 1, 0.1)).size() > 50);
}

TEST_CASE("one very large box among small ones is found by all it meets") {
  auto boxes = random_boxes(3, 300, 1, 0.05);
  boxes.insert(boxes.begin() + 17, Box{{-5, -0.4}, {5, 0.3}});
  check(boxes);
  boxes.push_back({{-100, -100}, {100, 100}});
  check(boxes);
}

TEST_CASE("boxes scattered far apart are found, with few cells") {
  auto boxes = random_boxes(4, 100, 1, 0.2);
  for (const Box& box : random_boxes(5, 100, 1, 0.2))
    boxes.push_back({box.low + Vec2{1e7, 0}, box.high + Vec2{1e7, 0}});
  boxes.push_back({{0, 1e9}, {1, 1e9 + 1}});
  boxes.push_back({{-1e9, 5e8}, {-1e9 + 1, 5e8 + 1}});
  check(boxes);
}

TEST_CASE("boxes in a line, across or along, are found") {
  for (const Vec2& step : {Vec2{0.9, 0}, Vec2{0, 0.9}, Vec2{0.9, 0.9}, Vec2{1, 1}}) {
    std::vector<Box> boxes;
    for (int i = 0; i < 500; ++i) boxes.push_back({i * step, i * step + Vec2{1, 1}});
    check(boxes);
    CHECK(brute_force(boxes).size() == 499);
  }
}

TEST_CASE("boxes without height, or that coincide, are found") {
  check(std::vector<Box>(7, Box{{0.3, 0.4}, {1, 2}}));
  check({{{0, 0}, {1, 0}}, {{0.5, 0}, {2, 0}}, {{3, 0}, {4, 0}}});
  check({{{0, 0}, {0, 1}}, {{0, 0.5}, {0, 2}}, {{0, 3}, {0, 4}}});
  // Not even an extent to size a cell by.
  check(std::vector<Box>(4, Box{{0.3, 0.4}, {0.3, 0.4}}));
  check(std::vector<Box>(4, Box{{0, 0}, {0, 0}}));
}

TEST_CASE("none or one box makes no pair") {
  check({});
  check({{{0, 0}, {1, 1}}});
}

TEST_CASE("the order of pairs depends on the boxes only") {
  const auto boxes = random_boxes(9, 200, 1, 0.3);
  CHECK(found_in(boxes) == found_in(boxes));
}

TEST_CASE("the grid finds the same pairs far from the origin and in other units") {
  // Powers of two keep every comparison what it was.
  auto boxes = random_boxes(11, 200, 1, 0.2);
  const Pairs here = brute_force(boxes);
  for (Box& box : boxes) box = {1048576 * box.low, 1048576 * box.high};
  check(boxes);
  CHECK(brute_force(boxes) == here);
  auto shifted = random_boxes(11, 200, 1, 0.2);
  for (Box& box : shifted) {
    box.low.array() += 1e6;
    box.high.array() += 1e6;
  }
  check(shifted);
}

TEST_CASE("a negative skin is refused by name, for a grid") {
  CHECK_NOTHROW(UniformGrid{.relative_skin = 0}.validate());
  CHECK_THROWS_WITH_AS(UniformGrid{.relative_skin = -0.1}.validate(),
                       "UniformGrid.relative_skin = -0.1: must be a finite number, 0 or above",
                       InvalidInput);
}
