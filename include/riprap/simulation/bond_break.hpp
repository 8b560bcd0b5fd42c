// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The record of a bond that has broken.

#include <array>
#include <cstdint>

#include <riprap/bond/bond_law/concepts.hpp>
#include <riprap/core/ids.hpp>
#include <riprap/core/vec2.hpp>

namespace riprap {

/// One bond is no more.
struct BondBreak {
  std::uint64_t step = 0;  ///< `steps()` at the end of it, as in a BreakEvent
  double time = 0;         ///< [s]
  std::array<ParticleId, 2> particles{no_particle, no_particle};
  BondFailure failure = BondFailure::none;  ///< none: it was broken by the program, or with dust
  Vec2 place{0, 0};                         ///< of the middle of its edge then [m]
  bool separates = false;                   ///< the two are no longer joined, by other bonds either
  std::array<Vec2, 2> ends{Vec2{0, 0}, Vec2{0, 0}};  ///< of its edge, in the first one's frame [m]
  double length = 0;                                 ///< of the edge when it was bonded [m]
  /// Stored in the bond, less what the contact that takes its place stores [J].
  double energy = 0;

  static constexpr bool names_all_members = false;
  static void for_each_field(auto& self, auto&& visit) {
    visit("step", self.step);
    visit("time", self.time);
    visit("particles", self.particles);
    visit("failure", self.failure);
    visit("place", self.place);
    visit("separates", self.separates);
    visit("ends", self.ends);
    visit("length", self.length);
    visit("energy", self.energy);
  }
};

}  // namespace riprap
