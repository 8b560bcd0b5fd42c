// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/pair/pair_map.hpp>

#include <doctest/doctest.h>

#include <cstdint>
#include <vector>

using namespace riprap;

TEST_CASE("entries follow their pairs, those of new pairs are fresh") {
  PairMap map;
  map.begin();
  for (const std::uint32_t k : {2u, PairMap::not_present, 0u}) map.add(k);
  map.finish(7);
  CHECK(map.from() == 0);
  CHECK(map.to() == 7);
  CHECK(map.size() == 3);
  CHECK(map.previous_index(0) == 2);

  std::vector<double> workspace;
  std::vector<double> array{10, 11, 12};
  map.carry(array, workspace, -1.0);
  CHECK(array == std::vector<double>{12, -1, 10});
  // Two entries for each pair.
  std::vector<double> both{1, 2, 3, 4, 5, 6};
  map.carry(both, workspace, -1.0, 2);
  CHECK(both == std::vector<double>{5, 6, -1, -1, 1, 2});

  map.begin();
  map.finish(9);
  CHECK(map.from() == 7);
  map.carry(array, workspace, -1.0);
  CHECK(array.empty());
}

TEST_CASE("pairs that are appended leave the others where they are, and are fresh") {
  PairMap map;
  map.begin();
  map.add(PairMap::not_present);
  map.add(PairMap::not_present);
  map.finish(1);
  map.append(3, 2);
  map.append(4, 3);
  CHECK(map.size() == 4);
  CHECK(map.previous_index(2) == 2);
  CHECK(map.previous_index(3) == PairMap::not_present);
  std::vector<double> workspace;
  std::vector<double> since_search{10, 11};
  std::vector<double> from_last{20, 21, 22};
  CHECK(map.leads_from(1));
  CHECK(map.leads_from(2));
  map.carry(from_last, workspace, -1.0);
  CHECK(from_last == std::vector<double>{20, 21, 22, -1});
  // The next search: arrays of the search before and of the last revision follow alike.
  map.begin();
  for (const std::uint32_t k : {3u, 1u, PairMap::not_present, 0u}) map.add(k);
  map.finish(4);
  CHECK(map.leads_from(1));
  CHECK_FALSE(map.leads_from(2));
  CHECK(map.leads_from(3));
  map.carry(since_search, workspace, -1.0);
  CHECK(since_search == std::vector<double>{-1, 11, -1, 10});
  map.carry(from_last, workspace, -2.0);
  CHECK(from_last == std::vector<double>{-1, 21, -2, 20});
}
