// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Pieces that are counted and no longer simulated.

#include <riprap/core/ids.hpp>

namespace riprap {

/// A piece too small to be simulated: part of the rock and of the grading, without place or force.
struct DustPiece {
  ParticleId root = no_particle;  ///< the intact particle it was once part of
  double area = 0;                ///< [m^2]
  MaterialIndex material = 0;

  static void for_each_field(auto& self, auto&& visit) {
    visit("root", self.root);
    visit("area", self.area);
    visit("material", self.material);
  }
};

}  // namespace riprap
