// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// No pairs. The file to copy for a broad phase of your own.

#include <span>

#include <riprap/contact/broad_phase/concepts.hpp>

namespace riprap {

/// Visits nothing: no contacts are searched.
struct NoPairs {
  static constexpr double relative_skin = 1;  ///< rebuilds are rare [-]

  template <class Visit>
  void visit_pairs(std::span<const Box>, Visit&&) const {}
};

static_assert(BroadPhase<NoPairs>);

}  // namespace riprap
