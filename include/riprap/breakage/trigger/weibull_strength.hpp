// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Failed-element ratio with a random strength for every particle: larger ones are weaker.

#include <cmath>
#include <cstdint>

#include <riprap/breakage/trigger/concepts.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/core/ids.hpp>
#include <riprap/core/splitmix64.hpp>

namespace riprap {

/// The strength of a particle of area A is the criterion's times a factor s with
/// P(s) = 1 - exp(-(d / d_0)^D s^m), d / d_0 = sqrt(A / A_0) (Weibull 1951): the same draw for a
/// particle all its life, another for each of its pieces. Of particles of one size a share of
/// exp(-1), 37 %, is stronger than s = (d / d_0)^(-D / m): the size effect. D is 2 where flaws are
/// counted by the area of the particle, as for prisms of one thickness, and 3 where they are
/// counted by the volume of a grain, d^3, as for the rock that the particle stands for (McDowell
/// and Bolton 1998). The breaking rule is that of FailedElementRatio.
struct WeibullStrength {
  double modulus = 5;  ///< m [-]; the higher, the more alike the particles; infinity: all alike
  double reference_area =
      2e-4;               ///< A_0 [m^2]: a particle of this area has the characteristic strength
  double critical = 0.4;  ///< RatF [-]
  std::uint64_t seed = 1;
  double dimension = 2;  ///< D [-]; 0: no size effect

  /// Strength of a particle over that of the criterion [-].
  [[nodiscard]] double strength_factor(ParticleId id, double area) const {
    if (std::isinf(modulus)) return 1;
    const double by_area = -std::log1p(-draw(seed, id)) * reference_area / area;
    return std::pow(by_area * std::pow(reference_area / area, 0.5 * dimension - 1), 1 / modulus);
  }
  [[nodiscard]] bool operator()(const FailureCount& failures) const {
    return failures.ratio() >= critical;
  }
  [[nodiscard]] std::size_t failed_elements_needed(std::size_t elements) const {
    return failed_elements_for_ratio(elements, critical);
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("modulus", self.modulus);
    visit("reference_area", self.reference_area);
    visit("critical", self.critical);
    visit("seed", self.seed);
    visit("dimension", self.dimension);
  }

  void validate() const {
    require(modulus > 0, "WeibullStrength.modulus", modulus, "must be a number above 0");
    require_positive("WeibullStrength.reference_area", reference_area);
    require_positive("WeibullStrength.critical", critical);
    require_non_negative("WeibullStrength.dimension", dimension);
  }
};

static_assert(Trigger<WeibullStrength>);

}  // namespace riprap
