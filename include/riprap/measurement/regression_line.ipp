// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

#include <Eigen/QR>
#include <riprap/measurement/regression_line.hpp>

namespace riprap {

RIPRAP_INLINE RegressionLine regression_line(std::span<const Vec2> points) {
  const auto count = static_cast<Eigen::Index>(points.size());
  require(count >= 2, "regression_line: number of points", static_cast<double>(count),
          "must be 2 or more");
  Eigen::MatrixX2d terms(count, 2);
  Eigen::VectorXd y(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Vec2& p = points[static_cast<std::size_t>(i)];
    terms.row(i) << 1, p.x();
    y[i] = p.y();
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixX2d> factors(terms);
  require(factors.rank() == 2, "regression_line: x of all points", points.front().x(),
          "must not be the same");
  const Eigen::Vector2d line = factors.solve(y);
  return {line[0], line[1],
          std::sqrt((terms * line - y).squaredNorm() / static_cast<double>(count))};
}

}  // namespace riprap
