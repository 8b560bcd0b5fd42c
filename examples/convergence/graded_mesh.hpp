// SPDX-License-Identifier: BSL-1.0
#pragma once
// A mesh whose triangles grow with the distance from given points. No Mesher of riprap: a mesher
// is given the shape of a particle and not its contacts, and divides edges evenly.

#include <span>
#include <vector>

#include <riprap/stress/mesher/mesh.hpp>

namespace convergence {

// Half of the triangles by UniformMesher, then bisections (Rivara 1984: across the longest edge, of
// the neighbour first where its longest edge is another) of the triangle with the largest angle of
// view from the nearest point, until there are as many as asked for.
// @param points on the boundary of the ring, in its frame [m]
[[nodiscard]] riprap::Mesh graded_mesh(const std::vector<riprap::Vec2>& ring,
                                       std::span<const riprap::Vec2> points, unsigned triangles);

}  // namespace convergence
