// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/pair/pair_map.hpp>

#include <doctest/doctest.h>

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
