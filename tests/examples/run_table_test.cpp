// SPDX-License-Identifier: BSL-1.0
#include <run_table/tasks.hpp>
#include <run_table/work_through.hpp>

#include <doctest/doctest.h>

#include <atomic>
#include <stdexcept>

#include <support/temporary_file.hpp>

using namespace run_table;
using riprap::test::TemporaryFile;

TEST_CASE("a result is made once for each key") {
  const TemporaryFile file;
  int runs = 0;
  Task task{file.path(), "# a", [&] { return std::to_string(++runs) + "\n"; }};
  CHECK(!result_of(task));
  for (int i = 0; i < 3; ++i) make_results({task}, 2);
  CHECK(result_of(task).value() == "1\n");
  CHECK(file.text() == "# a\n1\n");
  task.key = "# b";
  CHECK(!result_of(task));
  make_results({task}, 1);
  CHECK(result_of(task).value() == "2\n");
}

TEST_CASE("a run that fails is named, and the others are made") {
  const TemporaryFile bad;
  const TemporaryFile good;
  const std::vector<Task> tasks{
      {bad.path(), "# a", []() -> std::string { throw std::runtime_error("no"); }},
      {good.path(), "# b", [] { return std::string("x\n"); }}};
  CHECK_THROWS_WITH_AS(make_results(tasks, 1), (bad.path() + ": no").c_str(), std::runtime_error);
  CHECK(!result_of(tasks[0]));
  CHECK(result_of(tasks[1]).value() == "x\n");
}

TEST_CASE("a cell of a table") {
  CHECK(cell({2}, "%.1f", 10) == "20.0");
  CHECK(cell({1, 2, 3}, "%.1f") == "2.0 ± 1.0");
}

TEST_CASE("every piece of work is done once, whatever the number of threads") {
  for (const unsigned jobs : {1U, 3U, 40U}) {
    std::vector<std::atomic<int>> done(20);
    work_through(done.size(), jobs, [&](std::size_t k) { ++done[k]; });
    for (const std::atomic<int>& d : done) CHECK(d == 1);
  }
  work_through(0, 2, [](std::size_t) { CHECK(false); });
}

TEST_CASE("durations in the unit that suits them") {
  CHECK(duration_text(40) == "40 s");
  CHECK(duration_text(720) == "12 min");
  CHECK(duration_text(18720) == "5.2 h");
}
