// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>
#include <exception>
#include <memory>
#include <stdexcept>
#include <support/violated.hpp>
#include <thread>
#include <vector>

#include <riprap/conformance/execution.hpp>
#include <riprap/core/execution/serial.hpp>
#ifdef _OPENMP
#include <riprap/core/execution/threads.hpp>
#endif

using namespace riprap;
using test::check_violated;

namespace {

struct LastToFirst {
  template <class Work>
  void run(std::size_t tasks, Work&& work) const {
    std::exception_ptr error;
    while (tasks-- > 0) try {
        work(tasks);
      } catch (...) {
        error = std::current_exception();
      }
    if (error) std::rethrow_exception(error);
  }
};

/// Serial, with `change` instead of each call.
template <class Change>
struct Altered {
  Change change;
  template <class Work>
  void run(std::size_t tasks, Work&& work) const {
    for (std::size_t k = 0; k < tasks; ++k) change(work, k, tasks);
  }
};
template <class Change>
Violations violations_of(Change change) {
  return execution_violations(Altered<Change>{change});
}

/// Runs the first task also where there are none.
struct AtLeastOne {
  template <class Work>
  void run(std::size_t tasks, Work&& work) const {
    std::size_t k = 0;
    do work(k);
    while (++k < tasks);
  }
};

/// Returns before its tasks have ended.
class Impatient {
 public:
  template <class Work>
  void run(std::size_t tasks, Work&& work) const {
    begun_->emplace_back([tasks, work] {
      try {
        Serial{}.run(tasks, work);
      } catch (...) {
        // Lost.
      }
    });
  }

 private:
  std::shared_ptr<std::vector<std::jthread>> begun_ = std::make_shared<std::vector<std::jthread>>();
};

/// As LastToFirst, but keeps the exception that came first.
struct FirstComeFirstThrown {
  template <class Work>
  void run(std::size_t tasks, Work&& work) const {
    std::exception_ptr error;
    while (tasks-- > 0) try {
        work(tasks);
      } catch (...) {
        if (!error) error = std::current_exception();
      }
    if (error) std::rethrow_exception(error);
  }
};

/// LastToFirst that ends at any exception.
struct Backwards {
  template <class Work>
  void run(std::size_t tasks, Work&& work) const {
    while (tasks-- > 0) work(tasks);
  }
};

}  // namespace

TEST_CASE("the executions of riprap obey the axioms") {
  CHECK(to_text(execution_violations(Serial{})) == "");
#ifdef _OPENMP
  for (const int count : {1, 2, 5}) CHECK(to_text(execution_violations(Threads{count})) == "");
#endif
}

TEST_CASE("a user's execution obeys the axioms") {
  CHECK(to_text(execution_violations(LastToFirst{})) == "");
}

TEST_CASE("an execution that leaves a task out, or repeats one, is reported") {
  check_violated(violations_of([](auto&& work, auto k, auto tasks) {
                   if (k + 1 < tasks) work(k);
                 }),
                 "every task is done: tasks left out");
  check_violated(violations_of([](auto&& work, auto k, auto) {
                   work(k);
                   if (k == 500) work(k);
                 }),
                 "no task is done twice: tasks repeated");
}

TEST_CASE("an execution that calls for what is no task is reported") {
  const std::string_view axiom = "nothing else is done: calls that are no task";
  check_violated(violations_of([](auto&& work, auto k, auto) { work(k + 1); }), axiom);
  check_violated(execution_violations(AtLeastOne{}), axiom);
}

TEST_CASE("an execution that does not wait is reported") {
  check_violated(execution_violations(Impatient{}),
                 "run returns when all tasks are done: tasks that were");
}

TEST_CASE("an execution that loses an exception, or takes another one, is reported") {
  const std::string_view axiom = "of all exceptions that of the lowest task comes out: task";
  check_violated(violations_of([](auto&& work, auto k, auto) {
                   try {
                     work(k);
                   } catch (...) {
                     // Lost.
                   }
                 }),
                 axiom);
  check_violated(violations_of([](auto&& work, auto k, auto) {
                   try {
                     work(k);
                   } catch (const std::exception& error) {
                     throw std::runtime_error(error.what());
                   }
                 }),
                 axiom);
  const Violations violations = execution_violations(FirstComeFirstThrown{});
  check_violated(violations, axiom);
  CHECK(violations.size() == 1);
}

TEST_CASE("an execution that ends at any exception must have done what comes before it") {
  check_violated(execution_violations(Backwards{}),
                 "tasks below the one that throws are done: tasks left out");
}
