// SPDX-License-Identifier: BSL-1.0
#pragma once
// What was measured, as tables in Markdown and as charts.

#include <string>
#include <vector>

#include <riprap/output/svg.hpp>

#include "measurement.hpp"

namespace convergence {

// Of all particles of one origin.
struct MeasuredSet {
  std::string name;
  bool pieces = false;
  bool plane_strain = false;  // measured in plane strain, too
  std::vector<Measurement> measurements{};
};

[[nodiscard]] std::string tables(const std::vector<MeasuredSet>& sets);
// Disc and bar; measured here, in a second or two.
[[nodiscard]] std::string closed_form_table();
[[nodiscard]] riprap::Svg charts(const std::vector<MeasuredSet>& sets);

}  // namespace convergence
