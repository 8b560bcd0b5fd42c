// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A particle breaks as soon as any of its elements has failed.

#include <riprap/breakage/trigger/concepts.hpp>

namespace riprap {

/// Weakest-element rule: strength is that of the most loaded element, and so depends on the mesh.
struct AnyElement {
  [[nodiscard]] bool operator()(const FailureCount& failures) const { return failures.failed > 0; }
  [[nodiscard]] std::size_t failed_elements_needed(std::size_t /*elements*/) const { return 1; }
};

static_assert(Trigger<AnyElement>);

}  // namespace riprap
