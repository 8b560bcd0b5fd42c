// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/core/vec2.hpp>
#include <riprap/measurement/compression_line.hpp>
#include <riprap/measurement/regression_line.hpp>

namespace riprap {

RIPRAP_INLINE CompressionLine compression_line(std::span<const CompressionState> states) {
  std::vector<Vec2> points;
  CompressionLine line;
  for (const CompressionState& s : states) {
    require_positive("compression_line: stress", s.stress);
    line.lowest = points.empty() ? s.stress : std::min(line.lowest, s.stress);
    line.highest = std::max(line.highest, s.stress);
    points.push_back({std::log(s.stress), s.void_ratio});
  }
  const RegressionLine fit = regression_line(points);
  line.slope = -fit.slope;
  line.intercept = fit.intercept;
  line.scatter = fit.scatter;
  return line;
}

RIPRAP_INLINE CompressionYield compression_yield(std::span<const CompressionState> states) {
  constexpr std::size_t least = 3;  // states of a line
  require(states.size() >= 2 * least, "compression_yield: number of states",
          static_cast<double>(states.size()), "must be 6 or more");
  for (std::size_t i = 1; i < states.size(); ++i)
    require(states[i].stress > states[i - 1].stress, "compression_yield: stress", states[i].stress,
            "must be above that of the state before");
  CompressionYield best;
  double least_squares = std::numeric_limits<double>::infinity();
  for (std::size_t count = least; count + least <= states.size(); ++count) {
    const CompressionLine before = compression_line(states.first(count));
    const CompressionLine after = compression_line(states.subspan(count));
    const double squares =
        static_cast<double>(count) * before.scatter * before.scatter +
        static_cast<double>(states.size() - count) * after.scatter * after.scatter;
    if (squares >= least_squares) continue;
    least_squares = squares;
    best.before = before;
    best.after = after;
  }
  const double stress = std::exp((best.after.intercept - best.before.intercept) /
                                 (best.after.slope - best.before.slope));
  if (stress >= states.front().stress && stress <= states.back().stress) best.stress = stress;
  return best;
}

}  // namespace riprap
