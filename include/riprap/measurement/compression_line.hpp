// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Straight lines of compression tests: void ratio against the logarithm of stress, and the yield
/// stress between two of them.

#include <cmath>
#include <limits>
#include <span>

#include <riprap/core/linkage.hpp>

namespace riprap {

/// A state of a compression test.
struct CompressionState {
  double stress = 0;      ///< mean or vertical [Pa], positive in compression
  double void_ratio = 0;  ///< pores over solids [-]
};

/// void ratio = intercept - slope ln(stress / 1 Pa). The slope is lambda of the normal compression
/// line, kappa of unloading.
struct CompressionLine {
  double slope = 0;      ///< fall of the void ratio per unit of the natural logarithm [-]
  double intercept = 0;  ///< void ratio at 1 Pa [-]
  double scatter = 0;    ///< root mean square distance of the states from it, in void ratio [-]
  double lowest = 0;     ///< stress of the states [Pa]
  double highest = 0;    ///< [Pa]

  [[nodiscard]] double void_ratio_at(double stress) const {
    return intercept - slope * std::log(stress);
  }
};

/// Least squares of the distances in void ratio. Throws InvalidInput for a stress that is not above
/// 0, or fewer than two different ones.
[[nodiscard]] CompressionLine compression_line(std::span<const CompressionState> states);

/// Two lines through the states of first loading, which meet at the yield stress.
struct CompressionYield {
  CompressionLine before;
  CompressionLine after;
  /// Where the lines meet [Pa]; not-a-number if they meet outside of the states' range.
  double stress = std::numeric_limits<double>::quiet_NaN();
};

/// Divides the states, which ascend in stress, so that two lines of compression_line leave the
/// least sum of squares; each has three states or more. A construction for an e-log p curve that
/// needs no judgement by eye, as Casagrande's does. It finds a stress on any curve that bends
/// down: of a sample of linear springs, whose void ratio falls in proportion to the stress, too.
/// Throws InvalidInput for fewer than six states, or stresses that do not ascend.
[[nodiscard]] CompressionYield compression_yield(std::span<const CompressionState> states);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/measurement/compression_line.ipp>
#endif
