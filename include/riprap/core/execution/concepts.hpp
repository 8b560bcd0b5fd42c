// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The role of execution: runs the independent tasks of a step, serially or in parallel.

#include <algorithm>
#include <cstddef>

#include <riprap/core/policy.hpp>

namespace riprap {

namespace requirements {

/// Archetype of the work of a step.
struct ExecutedWork {
  void operator()(std::size_t) const {}
};

/// `execution.run(tasks, work)` calls `work(k)` once for every k below `tasks`, in any order and
/// maybe several at a time, and returns when all are done. Of exceptions that calls have thrown it
/// throws on the one of the lowest k. Const: steps do not depend on those before them.
template <class E>
concept ExecutionRun =
    requires(const E& execution, const std::size_t tasks) { execution.run(tasks, ExecutedWork{}); };

}  // namespace requirements

/// An `Execution` runs independent tasks. The partition into tasks and the order in which sums are
/// reduced do not depend on it: results are bitwise identical for every model.
template <class E>
concept Execution = Policy<E> && requirements::ExecutionRun<E>;

template <class E>
consteval bool check_execution() {
  check_policy<E>();
  static_assert(requirements::ExecutionRun<E>,
                "riprap: an Execution must have template <class Work> void run(std::size_t tasks, "
                "Work&&) const");
  return Execution<E>;
}

/// Number of bodies of a task (chunk size): small enough to balance the load, large enough to
/// outweigh the overhead of a task.
inline constexpr std::size_t task_size = 256;

/// Number of tasks for `count` bodies.
[[nodiscard]] constexpr std::size_t task_count(std::size_t count) {
  return (count + task_size - 1) / task_size;
}

/// Index of the task that processes a body.
[[nodiscard]] constexpr std::size_t task_of(std::size_t body) { return body / task_size; }

/// Calls `work(task, first, last)` for every task of `count` bodies.
template <Execution E, class Work>
void for_each_task(const E& execution, std::size_t count, Work&& work) {
  execution.run(task_count(count), [&](std::size_t task) {
    work(task, task * task_size, std::min(count, (task + 1) * task_size));
  });
}

}  // namespace riprap
