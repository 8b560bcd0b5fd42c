// SPDX-License-Identifier: BSL-1.0
#include <riprap/acceleration/batching/prefetch.hpp>

#include <doctest/doctest.h>

#include <vector>

TEST_CASE("fetched memory is as it was, from one byte to many lines") {
  std::vector<char> memory(1000, 'r');
  for (const std::size_t bytes : {1U, 64U, 65U, 1000U}) riprap::prefetch(memory.data(), bytes);
  CHECK(memory == std::vector<char>(1000, 'r'));
}
