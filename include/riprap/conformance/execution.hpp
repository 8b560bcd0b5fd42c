// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The axioms of the execution of tasks.

#include <atomic>
#include <chrono>
#include <cstddef>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <riprap/conformance/violations.hpp>
#include <riprap/core/execution/concepts.hpp>

namespace riprap {
namespace internal {

/// How often each task was called. Shared with the work, so that calls that come too late do no
/// harm.
struct TaskCalls {
  explicit TaskCalls(std::size_t tasks) : of(tasks) {}
  std::vector<std::atomic<int>> of;
  std::atomic<int> others{0};  ///< numbers that are none of a task

  void add(std::size_t task) { ++(task < of.size() ? of[task] : others); }
};

template <Execution E>
void check_calls(const E& execution, std::size_t tasks, AxiomCheck& check) {
  check.at("number of tasks", static_cast<double>(tasks));
  const auto calls = std::make_shared<TaskCalls>(tasks);
  execution.run(tasks, [calls](std::size_t k) { calls->add(k); });
  double left_out = 0;
  double repeated = 0;
  for (const std::atomic<int>& n : calls->of) {
    left_out += n == 0;
    repeated += n > 1;
  }
  check.equal("every task is done: tasks left out", left_out, 0, 0);
  check.equal("no task is done twice: tasks repeated", repeated, 0, 0);
  check.equal("nothing else is done: calls that are no task", calls->others, 0, 0);
}

/// Tasks that take a while, so that it shows whether they are waited for.
template <Execution E>
void check_waiting(const E& execution, AxiomCheck& check) {
  constexpr int tasks = 8;
  check.at("number of tasks", tasks);
  const auto done = std::make_shared<std::atomic<int>>(0);
  execution.run(tasks, [done](std::size_t) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    ++*done;
  });
  check.equal("run returns when all tasks are done: tasks that were", *done, tasks, 0);
}

/// Thrown by a task.
struct TaskFailure : std::runtime_error {
  explicit TaskFailure(std::size_t k) : std::runtime_error("task failed"), task(k) {}
  std::size_t task;
};

template <Execution E>
void check_failure(const E& execution, const std::set<std::size_t>& failing, AxiomCheck& check) {
  constexpr std::size_t tasks = 40;
  const std::size_t lowest = *failing.begin();
  check.at("lowest task that throws", static_cast<double>(lowest));
  const auto calls = std::make_shared<TaskCalls>(tasks);
  constexpr double none = -1;
  double thrown = none;
  try {
    execution.run(tasks, [calls, failing](std::size_t k) {
      calls->add(k);
      if (failing.contains(k)) throw TaskFailure(k);
    });
  } catch (const TaskFailure& failure) {
    thrown = static_cast<double>(failure.task);
  } catch (...) {
    // Another one than was thrown.
  }
  check.equal("of all exceptions that of the lowest task comes out: task", thrown,
              static_cast<double>(lowest), 0);
  double left_out = 0;
  for (std::size_t k = 0; k < lowest; ++k) left_out += calls->of[k] == 0;
  check.equal("tasks below the one that throws are done: tasks left out", left_out, 0, 0);
}

}  // namespace internal

/// Which axioms an execution breaks. Scheduling of threads varies, so each check is
/// repeated.
template <Execution E>
[[nodiscard]] Violations execution_violations(const E& execution) {
  AxiomCheck check;
  for (int again = 0; again < 5; ++again) {
    for (const std::size_t tasks : {0u, 1u, 2u, 7u, 1000u})
      internal::check_calls(execution, tasks, check);
    internal::check_waiting(execution, check);
    // An exception must not spoil the runs that follow.
    for (const std::set<std::size_t>& failing :
         {std::set<std::size_t>{0}, {39}, {7, 8, 30}, {11, 12, 13, 14, 15, 16, 17}, {0, 39}})
      internal::check_failure(execution, failing, check);
  }
  return std::move(check).violations();
}

}  // namespace riprap
