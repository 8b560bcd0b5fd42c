// SPDX-License-Identifier: BSL-1.0
#pragma once
// Charts and the table of the comparison.

#include <string>
#include <vector>

#include <riprap/output/svg.hpp>

#include "models.hpp"

namespace rivals {

// The runs of one model at one pressure, one for each sample.
struct ModelRuns {
  const RivalModel* model = nullptr;
  double pressure = 0;  // [Pa]
  std::vector<Json> samples{};
};

// Means over the samples: sin phi, volume, coordination, breakages, and the gradings before and
// after; a column of charts for each pressure.
riprap::Svg charts(const std::vector<ModelRuns>& runs);

// A row for each model and pressure, in Markdown: means and 95 % intervals.
std::string table(const std::vector<ModelRuns>& runs);

}  // namespace rivals
