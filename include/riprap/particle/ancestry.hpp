// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Identity of a particle, and the particle it came from.

#include <riprap/core/ids.hpp>

namespace riprap {

/// Identifier and fragmentation history of a particle.
struct Ancestry {
  ParticleId id = no_particle;
  ParticleId parent = no_particle;  ///< the particle whose break made this one
  ParticleId root = no_particle;    ///< the original intact particle
  unsigned generation = 0;          ///< breaks between the root and this one

  static void for_each_field(auto& self, auto&& visit) {
    visit("id", self.id);
    visit("parent", self.parent);
    visit("root", self.root);
    visit("generation", self.generation);
  }
};

}  // namespace riprap
