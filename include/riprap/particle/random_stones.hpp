// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Loose rectangular samples of stones from a library, convex or concave. Optional: not part of
/// riprap.hpp.

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <riprap/core/linkage.hpp>
#include <riprap/particle/random_placement.hpp>
#include <riprap/particle/stone.hpp>

namespace riprap {

/// In StoneAssembly::stone: a particle of no stone, a platen.
inline constexpr std::uint32_t no_stone = std::numeric_limits<std::uint32_t>::max();

/// Stones whose cells are particles of an assembly. The cells of one stone follow each other, in
/// the order of the library's, and are not tied to each other: that is for bonds to do.
struct StoneAssembly {
  Assembly assembly;
  /// Of each particle the number of its stone, from 0, or no_stone. Cells of one number are a
  /// cluster.
  std::vector<std::uint32_t> stone;

  [[nodiscard]] std::uint32_t count() const;  ///< of stones
  /// Particles by stone, by their places in the assembly: as bond_common_edges takes them.
  [[nodiscard]] std::vector<std::vector<std::size_t>> clusters() const;

  /// Does not compile: whether the cells of a stone are bonded is for the program to say.
  template <std::same_as<Assembly> A>
  operator A() const {
    static_assert(std::same_as<A, StoneAssembly>,
                  "riprap: a StoneAssembly is no Assembly: give its member assembly, after "
                  "bond_common_edges(sample.assembly, cluster) for each of sample.clusters() if "
                  "its stones are to hold together");
    return assembly;
  }
};

/// Places stones at random without overlap in a rectangle about the origin, between four platens or
/// walls as those of random_platen_assembly. Of the options, `count` and `diameters` are the
/// stones'; each is one of the library at random, turned at random and scaled to the area of a
/// circle of its diameter. `shape` and `outlines` have no effect. Same seed, same bytes. Throws
/// InvalidInput for options that break a rule, for an empty library or a stone without cells, and
/// where there is no room.
[[nodiscard]] StoneAssembly random_platen_stones(const RandomAssembly& options,
                                                 const std::vector<Stone>& library);

/// The same in a periodic rectangular cell. Cells of a stone at its border stay beside each other:
/// some are outside.
[[nodiscard]] StoneAssembly random_periodic_stones(const RandomAssembly& options,
                                                   const std::vector<Stone>& library);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/particle/random_stones.ipp>
#endif
