// SPDX-License-Identifier: BSL-1.0
#include <riprap/core/argsort.hpp>

#include <doctest/doctest.h>

#include <riprap/core/random.hpp>

using namespace riprap;

TEST_CASE("no keys have an empty order") { CHECK(argsort({}).empty()); }

TEST_CASE("the order rises, and equal keys keep theirs") {
  const std::vector<double> keys{3, -1, 2, -1, 3, -5};
  CHECK(argsort(keys) == std::vector<std::size_t>{5, 1, 3, 2, 0, 4});
}

// Sorts of more than 16 elements partition first, and do not keep equal ones in place of
// themselves.
TEST_CASE("of many keys each index comes once") {
  Random random(3);
  std::vector<double> keys;
  for (int i = 0; i < 1000; ++i) keys.push_back(static_cast<int>(random.uniform(0, 50)));
  const auto order = argsort(keys);
  REQUIRE(order.size() == keys.size());
  std::vector<bool> seen(keys.size(), false);
  for (std::size_t k = 0; k < order.size(); ++k) {
    CHECK(!seen[order[k]]);
    seen[order[k]] = true;
    if (k == 0) continue;
    const std::size_t last = order[k - 1];
    CHECK((keys[last] < keys[order[k]] || (keys[last] == keys[order[k]] && last < order[k])));
  }
}
