// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// No damping: energy leaves through contacts only. The file to copy for a damping of your own.

#include <riprap/dynamics/damping/concepts.hpp>

namespace riprap {

/// Adds nothing.
struct NoDamping {
  [[nodiscard]] Wrench operator()(const Body&, const Wrench&) const { return {}; }
};

static_assert(Damping<NoDamping>);

}  // namespace riprap
