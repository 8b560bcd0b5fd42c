// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The straight line that predicts one measured quantity from another.

#include <cmath>
#include <span>

#include <riprap/core/errors.hpp>
#include <riprap/core/linkage.hpp>
#include <riprap/core/vec2.hpp>

namespace riprap {

/// y = intercept + slope x.
struct RegressionLine {
  double intercept = 0;  ///< in the unit of y
  double slope = 0;      ///< in the unit of y over that of x
  double scatter = 0;    ///< root mean square distance of the points from it along y
};

/// Least squares of the distances along y. Throws InvalidInput for fewer than two different x.
[[nodiscard]] RegressionLine regression_line(std::span<const Vec2> points);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/measurement/regression_line.ipp>
#endif
