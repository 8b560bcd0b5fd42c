// SPDX-License-Identifier: BSL-1.0
#include <paper/report/result_tables.hpp>

#include <doctest/doctest.h>

#include <paper/runs/plan.hpp>

TEST_CASE("every parameter that the report lists is recorded by a run") {
  const study::RunPlan plan{.mode = study::Mode::wb};
  const report::Table table = report::parameters_table(plan.parameters());
  CHECK(table.rows.size() > 20);
  for (const auto& row : table.rows) CHECK_MESSAGE(row[1] != "not recorded", row[0]);
}
