// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Bonds between particles whose edges lie on each other.

#include <cstddef>
#include <span>

#include <riprap/core/linkage.hpp>
#include <riprap/particle/assembly.hpp>

namespace riprap {

/// Bonds every two of some particles along the part that an edge of one and an opposite edge of the
/// other have in common: edges on one line, with the particles on either side of it. The edges need
/// not be of one length. In a periodic cell particles are bonded across its boundary, too. Bonds
/// are appended in the order of their particles.
/// @param particles places in `assembly.particles`, such as those of the cells of a cluster
/// @param tolerance distance of the two edges, and least length of the common part, over half the
/// distance of the farthest vertex from the first one, in the smaller particle [-]
/// @return the number of bonds that were added
/// Throws InvalidInput for a place that is not in the assembly, for a tolerance that is not above 0
/// and below 0.1, and for two particles that are bonded already.
std::size_t bond_common_edges(Assembly& assembly, std::span<const std::size_t> particles,
                              double tolerance = 1e-6);

/// The same for all particles of the assembly.
std::size_t bond_common_edges(Assembly& assembly, double tolerance = 1e-6);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/particle/bond_common_edges.ipp>
#endif
