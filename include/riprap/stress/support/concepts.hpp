// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The role of the support: what takes away the rigid modes of a loaded particle.

#include <span>
#include <type_traits>

#include <riprap/core/policy.hpp>
#include <riprap/stress/boundary_load.hpp>
#include <riprap/stress/influence_operator.hpp>

namespace riprap {

namespace requirements {

/// `S::needs_flexibility`: whether the operator must know displacements of the boundary, which cost
/// memory; a constant, for it holds for all particles.
template <class S>
concept SupportFlexibility = requires {
  *&S::needs_flexibility;  // of the class
  typename std::bool_constant<bool{S::needs_flexibility}>;
};

/// `support.apply_reactions(loads, op)` changes forces in place: supports become reactions. Const,
/// for one support serves all particles.
template <class S>
concept SupportSettle =
    requires(const S& support, const std::span<BoundaryLoad> loads, const InfluenceOperator& op) {
      support.apply_reactions(loads, op);
    };

}  // namespace requirements

/// A `Support` turns the contact loads of one particle into the loads that stress it.
template <class S>
concept Support =
    Policy<S> && requirements::SupportFlexibility<S> && requirements::SupportSettle<S>;

template <class S>
consteval bool check_support() {
  check_policy<S>();
  static_assert(requirements::SupportFlexibility<S>,
                "riprap: a Support must have static constexpr bool needs_flexibility");
  static_assert(requirements::SupportSettle<S>,
                "riprap: a Support must have void apply_reactions(std::span<BoundaryLoad>, const "
                "InfluenceOperator&) const");
  return Support<S>;
}

}  // namespace riprap
