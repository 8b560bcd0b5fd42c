#pragma once
/// @file
/// The role of the mesher.

#include <concepts>

#include <riprap/stress/mesh/mesh.hpp>

namespace riprap {

/// A `Mesher` cuts a convex polygon into triangles.
///
/// - `mesher(ring)` -> Mesh: `ring` in the body's own frame, centroid at the origin; the triangles
///   cover it exactly, and boundary nodes divide each edge evenly.
/// - `mesher.validate()`: throws InvalidInput for parameters that break a rule.
template <class M>
concept Mesher = requires(const M& mesher, Ring ring) {
  { mesher(ring) } -> std::same_as<Mesh>;
  mesher.validate();
};

}  // namespace riprap
