// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/pair/task_partition.hpp>

#include <doctest/doctest.h>

#include <span>
#include <vector>

#include <riprap/contact/pair/contact.hpp>

using namespace riprap;

TEST_CASE(
    "a task has the pairs of its first bodies, and those of earlier tasks that reach into it") {
  struct None {};
  using Pair = Contact<None, None>;
  constexpr BodyIndex t = task_size;
  const std::vector<Pair> pairs{{.a = 0, .b = 1},         {.a = 3, .b = t},
                                {.a = 3, .b = 2 * t + 1}, {.a = t, .b = t + 1},
                                {.a = t + 5, .b = 2 * t}, {.a = 2 * t, .b = 2 * t + 1}};
  std::vector<ContactTask> tasks;
  partition_pairs(std::span<const Pair>(pairs), 2 * t + 2, tasks);
  REQUIRE(tasks.size() == 3);
  CHECK(tasks[0].first_pair == 0);
  CHECK(tasks[0].last_pair == 3);
  CHECK(tasks[1].last_pair == 5);
  CHECK(tasks[2].last_pair == 6);
  CHECK(tasks[2].first_body == 2 * t);
  CHECK(tasks[2].last_body == 2 * t + 2);
  CHECK(tasks[0].shared_pairs.empty());
  CHECK(tasks[1].shared_pairs == std::vector<std::uint32_t>{1});
  CHECK(tasks[2].shared_pairs == std::vector<std::uint32_t>{2, 4});
  CHECK(tasks[0].shared_bodies.empty());
  CHECK(tasks[1].shared_bodies == std::vector<BodyIndex>{t});
  CHECK(tasks[2].shared_bodies == std::vector<BodyIndex>{2 * t, 2 * t + 1});
}
