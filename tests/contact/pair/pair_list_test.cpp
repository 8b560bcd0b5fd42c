// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/pair/pair_list.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <initializer_list>
#include <utility>
#include <vector>

using namespace riprap;

namespace {

struct NoCache {};
using Pair = Contact<int, NoCache>;  // the history marks the contact
using Pairs = std::vector<std::pair<BodyIndex, BodyIndex>>;

void renew(PairList<Pair>& list, const Pairs& pairs) {
  list.begin();
  for (const auto& [a, b] : pairs) list.add(a, b, {});
  list.finish();
}

std::vector<int> marks(const PairList<Pair>& list) {
  std::vector<int> all;
  for (const Pair& pair : list.pairs()) all.push_back(pair.history);
  return all;
}

}  // namespace

TEST_CASE("pairs are sorted and keep their contacts from list to list") {
  PairList<Pair> list;
  renew(list, {{1, 2}, {0, 2}, {0, 1}});
  REQUIRE(list.size() == 3);
  CHECK(list.pairs()[0].a == 0);
  CHECK(list.pairs()[1].b == 2);
  int mark = 0;
  for (Pair& pair : list.pairs()) pair.history = ++mark;
  const std::uint64_t revision = list.revision();
  renew(list, {{0, 1}, {0, 2}, {1, 2}});
  CHECK(list.revision() == revision);  // the same sequence
  CHECK(marks(list) == std::vector<int>{1, 2, 3});
  renew(list, {{1, 2}, {0, 1}});
  CHECK(list.revision() != revision);
  CHECK(list.map().from() == revision);
  CHECK(marks(list) == std::vector<int>{1, 3});
  CHECK(list.map().previous_index(1) == 2);
}

TEST_CASE("a pair is found by its bodies while it touches") {
  PairList<Pair> list;
  renew(list, {{0, 1}, {1, 2}, {0, 3}});
  for (Pair& pair : list.pairs()) pair.touching = pair.b != 2;
  Pair of{.a = 0, .b = 3};
  REQUIRE(list.find_touching(of));
  CHECK(list.find_touching(of) == &list.pairs()[1]);
  CHECK(!list.find_touching({.a = 1, .b = 2}));
  CHECK(!list.find_touching({.a = 2, .b = 3}));
}

TEST_CASE("pairs of a removed body are dropped, those behind it move up and keep their contacts") {
  PairList<Pair> list;
  renew(list, {{0, 1}, {0, 3}, {1, 2}, {2, 3}, {3, 4}});
  int mark = 0;
  for (Pair& pair : list.pairs()) pair.history = ++mark;
  const std::uint64_t revision = list.revision();
  list.remove(2);
  CHECK(marks(list) == std::vector<int>{1, 2, 5});
  CHECK(list.pairs()[1].b == 2);
  CHECK(list.pairs()[2].a == 2);
  CHECK(list.pairs()[2].b == 3);
  CHECK(list.map().from() == revision);
  CHECK(list.map().previous_index(2) == 4);
  // And in a new list, too.
  renew(list, {{0, 2}, {1, 3}, {2, 3}});
  CHECK(marks(list) == std::vector<int>{2, 0, 5});
}

TEST_CASE("the pairs of a second piece are appended, and have their places among the others") {
  PairList<Pair> list;
  renew(list, {{0, 1}, {0, 3}, {1, 2}, {2, 3}});
  int mark = 0;
  for (Pair& pair : list.pairs()) pair.history = ++mark;
  const std::uint64_t revision = list.revision();
  const std::vector<PairSide> of_1{{0, true}, {2, false}};
  list.divide(of_1, 1, 4);
  CHECK(list.searched() == 4);
  REQUIRE(list.size() == 7);  // (0, 4), (1, 4) and (2, 4)
  CHECK(list.revision() != revision);
  CHECK(list.map().from() == revision);
  for (Pair& pair : list.pairs().subspan(4)) pair.history = ++mark;
  // The second piece breaks in turn.
  list.divide(std::vector<PairSide>{{4, true}, {5, true}, {6, true}}, 4, 5);
  REQUIRE(list.size() == 11);
  std::vector<std::size_t> order(list.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::ranges::sort(order, [&](std::size_t k, std::size_t l) { return list.precedes(k, l); });
  for (std::size_t k = 1; k < order.size(); ++k) {
    const Pair& before = list.pairs()[order[k - 1]];
    const Pair& after = list.pairs()[order[k]];
    CHECK(std::pair(before.a, before.b) < std::pair(after.a, after.b));
  }
  for (const Pair& pair : list.pairs()) CHECK(list.find({.a = pair.a, .b = pair.b}) == &pair);
  CHECK(!list.find({.a = 3, .b = 5}));
  // They keep their contacts when a body is removed, and in a new list.
  list.remove(3);
  renew(list, {{0, 3}, {1, 3}, {1, 4}, {0, 2}});
  CHECK(marks(list) == std::vector<int>{0, 5, 6, 0});
}

TEST_CASE("pairs of a second piece with images have the images of its parent's") {
  using Periodic = Contact<int, NoCache, PeriodicDomain::Image>;
  PairList<Periodic> list;
  list.begin();
  list.add(0, 1, {1, 0});
  list.add(1, 2, {0, 1});
  list.finish();
  list.divide(std::vector<PairSide>{{0, true}, {1, false}}, 1, 3);
  REQUIRE(list.size() == 5);
  CHECK(list.pairs()[2].image == PeriodicDomain::Image{1, 0});
  CHECK(list.pairs()[3].image == PeriodicDomain::Image{});  // of the two pieces
  CHECK(list.pairs()[4].image == PeriodicDomain::Image{0, -1});
}
