// SPDX-License-Identifier: BSL-1.0
#pragma once
// Tests in sheared cells, those of one kind together, and what their examples make of them.

#include <string>
#include <vector>

#include "results.hpp"
#include "sheared_cell.hpp"

namespace shear_tests {

// The same test on several samples.
struct CellSeries {
  std::string name{};  // in legends
  std::vector<CellResult> results{};

  // Mean over the samples of `y(record)` against `x(record)`.
  template <class X, class Y>
  [[nodiscard]] std::vector<riprap::Vec2> curve(X&& x, Y&& y) const {
    std::vector<std::vector<riprap::Vec2>> curves;
    for (const CellResult& r : results) {
      auto& points = curves.emplace_back();
      for (const CellRecord& rec : r.records) points.push_back({x(rec), y(rec)});
    }
    return mean_curve(curves);
  }
  // Of a value of each sample.
  template <class Value>
  [[nodiscard]] run_study::Statistics of(Value&& value) const {
    std::vector<double> values;
    for (const CellResult& r : results) values.push_back(value(r));
    return run_study::statistics_of(values);
  }
};

// All tests of a series: a name, and the test of its first sample.
struct CellPlan {
  std::string name{};
  CellTest test{};

  // Of a sample, in any unit: it goes with the number of steps.
  [[nodiscard]] double work() const;
};

// Options.samples tests of each plan, of seeds one apart from that of the plan on; shows progress.
[[nodiscard]] std::vector<CellSeries> run_cells(const Options& options,
                                                const std::vector<CellPlan>& plans);

// The mean of `value(record)` over the last part of a test, by a share of its records.
template <class Value>
[[nodiscard]] double mean_at_end(const CellResult& r, double share, Value&& value) {
  const auto count = static_cast<std::size_t>(share * static_cast<double>(r.records.size()));
  double sum = 0;
  for (std::size_t i = r.records.size() - count; i < r.records.size(); ++i)
    sum += value(r.records[i]) / static_cast<double>(count);
  return sum;
}

// All records, in SI units; stresses are positive in compression.
[[nodiscard]] std::string table(const std::vector<CellSeries>& all);

// The options that all examples with a sheared cell write.
[[nodiscard]] Json options_json(const Options& options);

}  // namespace shear_tests
