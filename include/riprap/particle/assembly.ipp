// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <string>

#include <riprap/particle/assembly.hpp>

namespace riprap {

RIPRAP_INLINE Assembly Assembly::moved(const Vec2& shift) const {
  Assembly other = *this;
  for (PlacedParticle& p : other.particles) p.polygon = p.polygon.moved({}, shift);
  other.centre += shift;
  for (PlacedBond& bond : other.bonds)
    for (Vec2& end : bond.ends) end += shift;
  return other;
}

RIPRAP_INLINE void Assembly::validate() const {
  require_positive("Assembly.thickness", thickness);
  require(is_finite(period) && is_finite(centre), "Assembly.period + Assembly.centre",
          period.x() + period.y() + centre.x() + centre.y(), "must be finite");
  require_finite("Assembly.shear_offset", shear_offset);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const PlacedParticle& p = particles[i];
    if (!is_finite(p.velocity) || !std::isfinite(p.angular_velocity))
      throw InvalidInput(particle_text(static_cast<ParticleId>(i)) + ": velocity must be finite");
  }
  for (std::size_t k = 0; k < bonds.size(); ++k) {
    const PlacedBond& bond = bonds[k];
    const std::string name = "Assembly.bonds[" + std::to_string(k) + "]";
    for (const std::size_t i : {bond.a, bond.b})
      require(i < particles.size(), name + ": particle", static_cast<double>(i),
              "must be in the assembly");
    require(bond.a != bond.b, name + ": particle", static_cast<double>(bond.b),
            "must not be bonded to itself");
    const double length = (bond.ends[1] - bond.ends[0]).norm();
    require(length > 0 && std::isfinite(length), name + ": length [m]", length,
            "must be above 0 and finite");
    for (const std::size_t i : {bond.a, bond.b})
      if (is_wall(particles[i].motion))
        throw InvalidInput(name + ": " + particle_text(static_cast<ParticleId>(i)) +
                           " must not be a wall");
    if (period == Vec2{0, 0} && bond.image != PeriodicDomain::Image{})
      throw InvalidInput(name + ": image (" + std::to_string(bond.image.axis_1) + ", " +
                         std::to_string(bond.image.axis_2) +
                         "): must be zero where there is no period");
  }
}

}  // namespace riprap
