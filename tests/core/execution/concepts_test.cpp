// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <vector>

#include <riprap/core/execution/concepts.hpp>
#include <riprap/core/execution/serial.hpp>
#include <support/archetypes.hpp>

using namespace riprap;
namespace archetype = riprap::test::archetype;

namespace {

struct ChangesItself {
  void run(std::size_t, auto&&) {}
};
struct TakesAFunctionPointer {
  void run(std::size_t, void (*)(std::size_t)) const {}
};
struct WithoutRun {};
struct CountsInAReference {
  void run(std::size_t&, auto&&) const {}
};
struct ChangesTheWork {
  template <class Work>
  void run(std::size_t, Work&) const {}
};
struct NotCopyable : archetype::Execution {
  using archetype::Execution::Execution;
  NotCopyable(const NotCopyable&) = delete;
};

static_assert(Execution<Serial>);
static_assert(Execution<archetype::Execution>);
static_assert(!Execution<CountsInAReference>);
static_assert(!Execution<ChangesTheWork>);
static_assert(!Execution<NotCopyable>);
static_assert(!Execution<ChangesItself>);
static_assert(!Execution<TakesAFunctionPointer>);
static_assert(!Execution<WithoutRun>);

}  // namespace

TEST_CASE("tasks cover all bodies once, in order, and none is empty") {
  for (const std::size_t count :
       {std::size_t{0}, std::size_t{1}, task_size, task_size + 1, 3 * task_size - 1}) {
    std::vector<int> done(count, 0);
    std::size_t tasks = 0;
    for_each_task(Serial{}, count, [&](std::size_t task, std::size_t first, std::size_t last) {
      CHECK(task == tasks++);
      CHECK(first < last);
      for (std::size_t i = first; i < last; ++i) ++done[i];
    });
    CHECK(tasks == task_count(count));
    CHECK(done == std::vector<int>(count, 1));
  }
}
