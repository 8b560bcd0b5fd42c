// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The role of the support: what takes away the rigid modes of a loaded particle.

#include <concepts>
#include <span>
#include <type_traits>

#include <riprap/core/policy.hpp>
#include <riprap/stress/boundary_load.hpp>
#include <riprap/stress/influence_operator.hpp>

namespace riprap {

namespace requirements {

/// `S::needs_flexibility`: whether the operator must have displacements of the boundary, which cost
/// memory; a constant, for it holds for all particles.
template <class S>
concept SupportFlexibility = requires {
  *&S::needs_flexibility;  // of the class
  typename std::bool_constant<bool{S::needs_flexibility}>;
};

/// `support.apply_reactions(loads, op)` changes forces in place: supports become reactions. Const,
/// for one support serves all particles.
template <class S>
concept SupportReactions =
    requires(const S& support, const std::span<BoundaryLoad> loads, const InfluenceOperator& op) {
      support.apply_reactions(loads, op);
    };

/// Optional: `support.is_linear()`: whether `apply_reactions` leaves all loads as they are, so that
/// stresses are the superposition of those due to each contact force on its own. Const; a non-const
/// function would be ignored silently.
template <class S>
concept SupportLinear =
    !requires(S& support) { support.is_linear(); } || requires(const S& support) {
      { support.is_linear() } -> std::convertible_to<bool>;
    };

}  // namespace requirements

/// A `Support` turns the contact loads of one particle into the loads that stress it.
template <class S>
concept Support = Policy<S> && requirements::SupportFlexibility<S> &&
                  requirements::SupportReactions<S> && requirements::SupportLinear<S>;

/// A support that can be linear; `is_linear()` says whether it is. Particles can be screened under
/// a linear one.
template <class S>
concept LinearSupport = Support<S> && requires(const S& support) { support.is_linear(); };

template <class S>
consteval bool check_support() {
  check_policy<S>();
  static_assert(requirements::SupportFlexibility<S>,
                "riprap: a Support must have static constexpr bool needs_flexibility");
  static_assert(requirements::SupportReactions<S>,
                "riprap: a Support must have void apply_reactions(std::span<BoundaryLoad>, const "
                "InfluenceOperator&) const");
  static_assert(requirements::SupportLinear<S>,
                "riprap: is_linear of a Support must be bool is_linear() const");
  return Support<S>;
}

}  // namespace riprap
