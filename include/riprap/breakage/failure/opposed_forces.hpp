// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The two contact forces that press a particle most between their points.

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>

#include <riprap/breakage/failure/loaded_particle.hpp>

namespace riprap {

/// Two forces towards each other's point of contact.
struct OpposedForces {
  Vec2 from{0, 0};      ///< point of contact of one [m], laboratory coordinates
  Vec2 to{0, 0};        ///< that of the other [m]
  double force = 0;     ///< the smaller of their components along the line from point to point [N]
  double distance = 0;  ///< of the points [m]
};

/// Of all pairs of contacts that push against each other the one with the largest force; the first
/// one of equal pairs. Nothing where none do.
[[nodiscard]] inline std::optional<OpposedForces>
largest_opposed_forces(const LoadedParticle& particle) {
  const std::span<const ContactLoad> loads = particle.loads();
  OpposedForces largest;
  for (std::size_t i = 0; i < loads.size(); ++i)
    for (std::size_t j = i + 1; j < loads.size(); ++j) {
      const Vec2 along = loads[j].arm_lab - loads[i].arm_lab;
      const double distance = along.norm();
      if (distance == 0) continue;
      const double push = loads[i].force_lab.dot(along) / distance;
      const double against = -loads[j].force_lab.dot(along) / distance;
      const double force = std::min(push, against);
      if (force > largest.force)
        largest = {particle.point(loads[i]), particle.point(loads[j]), force, distance};
    }
  if (largest.force > 0) return largest;
  return std::nullopt;
}

}  // namespace riprap
