// SPDX-License-Identifier: BSL-1.0
#include <run_table/biaxial_numbers.hpp>
#include <run_table/tasks.hpp>

#include <doctest/doctest.h>

#include <stdexcept>

#include <support/message_of.hpp>
#include <support/temporary_file.hpp>

using namespace run_table;
using riprap::test::contains;
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

TEST_CASE("cells and rows of a table") {
  CHECK(cell({2}, "%.1f", 10) == "20.0");
  CHECK(cell({1, 2, 3}, "%.1f") == "2.0 ± 1.0");
  const TemporaryFile file;
  const Task task{file.path(), "# a",
                  [] { return to_lines({.peak = 0.5, .breakages = 12, .damping = 0.25}); }};
  make_results({task}, 1);
  const BiaxialNumbers numbers = numbers_of(task);
  CHECK(numbers.peak == 0.5);
  const std::string text = table({"case"}, {{"one", {numbers}}});
  CHECK(contains(text, "| case | peak sin φ |"));
  CHECK(contains(text, "| one | 0.500 | 0.000 | 0.0 | 0.00 | 12 |"));
  CHECK(contains(text, "| 25.0 |"));
  CHECK_THROWS_WITH_AS((void)numbers_of({file.path(), "# other"}),
                       (file.path() + ": no peak_sin_phi in its place").c_str(),
                       std::runtime_error);
}
