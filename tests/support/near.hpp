// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Comparison of numbers with a tolerance that is stated, in the number's own unit or relative.

#include <cmath>
#include <ostream>

namespace riprap::test {

/// Equal to a number that is `expected` to within `tolerance`; never equal to NaN.
struct Near {
  double expected = 0;
  double tolerance = 0;

  friend bool operator==(double value, const Near& near) {
    return std::abs(value - near.expected) <= near.tolerance;
  }
  friend std::ostream& operator<<(std::ostream& out, const Near& near) {
    const auto digits = out.precision(17);
    out << near.expected << " +- " << near.tolerance;
    out.precision(digits);
    return out;
  }
};

/// Absolute tolerance.
[[nodiscard]] inline Near near(double expected, double tolerance) { return {expected, tolerance}; }

/// Tolerance as a share of the expected value.
[[nodiscard]] inline Near near_relative(double expected, double share) {
  return {expected, share * std::abs(expected)};
}

}  // namespace riprap::test
