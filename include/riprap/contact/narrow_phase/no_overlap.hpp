// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// No contacts. The file to copy for a narrow phase of your own.

#include <riprap/contact/narrow_phase/concepts.hpp>

namespace riprap {

/// Never reports a contact; empty cache.
struct NoOverlap {
  struct Cache {};

  [[nodiscard]] std::optional<ContactGeometry> operator()(Ring, Ring, Cache&) const {
    return std::nullopt;
  }
};

static_assert(NarrowPhase<NoOverlap>);

}  // namespace riprap
