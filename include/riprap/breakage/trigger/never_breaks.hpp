// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Elements may fail, particles never break: for watching Rat alone. The file to copy for a trigger
/// of your own.

#include <riprap/breakage/trigger/concepts.hpp>

namespace riprap {

/// Always false.
struct NeverBreaks {
  [[nodiscard]] bool operator()(const FailureCount&) const { return false; }
  [[nodiscard]] std::size_t failed_elements_needed(std::size_t elements) const {
    return elements + 1;
  }
};

static_assert(Trigger<NeverBreaks>);

}  // namespace riprap
