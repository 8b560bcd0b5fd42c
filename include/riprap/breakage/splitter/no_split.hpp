// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Every cut is refused. The file to copy for a splitter of your own.

#include <riprap/breakage/splitter/concepts.hpp>

namespace riprap {

/// Particles crack and stay whole: cracks are still searched for, and no particle is checked again
/// until its contact partners change.
struct NoSplit {
  [[nodiscard]] std::optional<CutRings> operator()(Ring, const Line&, double) const {
    return std::nullopt;
  }
};

static_assert(Splitter<NoSplit>);

}  // namespace riprap
