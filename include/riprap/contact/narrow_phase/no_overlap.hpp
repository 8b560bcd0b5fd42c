// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Nobody ever touches. The file to copy for a narrow phase of your own.

#include <riprap/contact/narrow_phase/concepts.hpp>

namespace riprap {

/// Finds no contact and remembers nothing.
struct NoOverlap {
  struct Memory {};

  [[nodiscard]] std::optional<ContactGeometry> operator()(Ring, Ring, Memory&) const {
    return std::nullopt;
  }
};

static_assert(NarrowPhase<NoOverlap>);

}  // namespace riprap
