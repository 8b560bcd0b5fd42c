// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

#include <riprap/particle/assembly.hpp>

namespace riprap {

RIPRAP_INLINE Assembly Assembly::moved(const Vec2& shift) const {
  Assembly other = *this;
  for (PlacedParticle& p : other.particles) p.polygon = p.polygon.moved({}, shift);
  other.centre += shift;
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
}

}  // namespace riprap
