// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Unsupported particle: inertia forces balance the resultant of the contacts (inertia relief). The
/// default.

#include <riprap/stress/support/concepts.hpp>

namespace riprap {

/// Statically determinate: no contact is treated unlike another. The balancing is part of the
/// operator, so there is nothing left to do.
struct InertiaRelief {
  static constexpr bool needs_flexibility = false;

  [[nodiscard]] static constexpr bool is_linear() { return true; }
  void apply_reactions(std::span<BoundaryLoad>, const InfluenceOperator&) const {}
};

static_assert(LinearSupport<InertiaRelief>);

}  // namespace riprap
