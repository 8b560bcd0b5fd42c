#pragma once
/// @file
/// The role of the support: what takes away the rigid modes of a loaded particle.

#include <concepts>
#include <span>

#include <riprap/stress/boundary_load.hpp>
#include <riprap/stress/influence_operator.hpp>

namespace riprap {

/// A `Support` turns the contact loads of one particle into the loads that stress it.
///
/// - `support.settle(loads, op)`: changes forces in place (supports become reactions).
/// - `S::needs_flexibility`: whether the operator must know displacements of the boundary.
template <class S>
concept Support =
    requires(const S& support, std::span<BoundaryLoad> loads, const InfluenceOperator& op) {
      { S::needs_flexibility } -> std::convertible_to<bool>;
      support.settle(loads, op);
    };

}  // namespace riprap
