// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A particle breaks when the pressure of its largest contact force, by Hertz, reaches a limit.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <riprap/breakage/trigger/concepts.hpp>
#include <riprap/core/errors.hpp>

namespace riprap {

/// sqrt(F E* / (pi R t)) >= pressure, the largest pressure of the line contact of a cylinder with a
/// flat face of the same rock (Johnson, Contact Mechanics 1985, ch. 4), with E* = E / (2 (1 -
/// nu^2)), R the radius of the circle of the particle's area and F its largest normal force. It is
/// a limit on F over diameter and thickness, like those on the largest contact force of discs and
/// spheres (Russell and Muir Wood 2009, Ciantia et al. 2015). The mode is shear: Hertz's contact of
/// cylinders has its largest shear stress, 0.30 of the pressure, below the surface, and no tension.
struct HertzianStrength {
  /// Largest that a contact bears [Pa]; for the default rock it is that of a disc at which
  /// 2 F / (pi D t) is 12 MPa.
  double pressure = 658e6;

  [[nodiscard]] FailureMode operator()(const LoadedParticle& particle) const {
    double force = 0;
    for (const ContactLoad& load : particle.loads()) force = std::max(force, load.normal_force);
    const Rock& rock = particle.rock();
    const double modulus = rock.young / (2 * (1 - rock.poisson * rock.poisson));
    const double radius = std::sqrt(particle.area() / std::numbers::pi);
    const double squared = force * modulus / (std::numbers::pi * radius * particle.thickness());
    return squared >= pressure * pressure ? FailureMode::shear : FailureMode::intact;
  }

  static void for_each_field(auto& self, auto&& visit) { visit("pressure", self.pressure); }

  void validate() const { require_positive("HertzianStrength.pressure", pressure); }
};

static_assert(LoadTrigger<HertzianStrength>);

}  // namespace riprap
