// SPDX-License-Identifier: BSL-1.0
#include <riprap/core/execution/serial.hpp>

#include <doctest/doctest.h>

#include <stdexcept>
#include <vector>

using namespace riprap;

TEST_CASE("tasks run in order, and stop at the first that throws") {
  std::vector<std::size_t> done;
  const auto work = [&](std::size_t k) {
    if (k == 3) throw std::runtime_error("three");
    done.push_back(k);
  };
  CHECK_THROWS_WITH_AS(Serial{}.run(5, work), "three", std::runtime_error);
  CHECK(done == std::vector<std::size_t>{0, 1, 2});
}
