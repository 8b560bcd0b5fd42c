// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The role of the mesher.

#include <concepts>

#include <riprap/core/policy.hpp>
#include <riprap/stress/mesher/mesh.hpp>

namespace riprap {

namespace requirements {

/// `mesher(ring)` -> Mesh. `ring` is in the body's own frame, centroid at the origin; the triangles
/// cover it exactly, and boundary nodes divide each edge evenly. Const: equal rings get equal
/// meshes, whatever was meshed before.
template <class M>
concept MesherCall = requires(const M& mesher, const Ring ring) {
  { mesher(ring) } -> std::convertible_to<Mesh>;
};

}  // namespace requirements

/// A `Mesher` cuts a convex polygon into triangles.
template <class M>
concept Mesher = Policy<M> && requirements::MesherCall<M>;

template <class M>
consteval bool check_mesher() {
  check_policy<M>();
  static_assert(requirements::MesherCall<M>,
                "riprap: a Mesher must have Mesh operator()(Ring) const");
  return Mesher<M>;
}

}  // namespace riprap
