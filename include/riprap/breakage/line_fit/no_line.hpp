// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Never a line: failed particles stay whole. The file to copy for a line fit of your own.

#include <riprap/breakage/line_fit/concepts.hpp>

namespace riprap {

/// Draws nothing.
struct NoLine {
  [[nodiscard]] std::optional<Line> operator()(std::span<const WeightedPoint>,
                                               const FailurePlanes&) const {
    return std::nullopt;
  }
};

static_assert(LineFit<NoLine>);

}  // namespace riprap
