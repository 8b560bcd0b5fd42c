// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Average stress of an assembly from its contact forces, and what follows from it.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <riprap/core/errors.hpp>
#include <riprap/core/linkage.hpp>
#include <riprap/core/stress2.hpp>
#include <riprap/core/vec2.hpp>
#include <riprap/measurement/contact_sum.hpp>

namespace riprap {

namespace internal {

void require_finite_sum(const Stress2& sum);

template <class Contacts, class Term, Execution E = Serial>
[[nodiscard]] Stress2 sum_of_stresses(const Contacts& contacts, Term&& term,
                                      const E& execution = {}) {
  const auto [s11, s22, s12] = sum_over_contacts<3>(
      contacts,
      [&](const auto& c) {
        const Stress2 s = term(c);
        return std::array{s.s11, s.s22, s.s12};
      },
      execution);
  return {s11, s22, s12};
}

}  // namespace internal

/// Eq. 13 (Rothenburg 1980): sigma_ij = 1 / (A t) sum of f_i l_j over contacts, compression
/// positive, symmetric part. `contacts` offers for_each_touching(visit); f is the force on b, l the
/// branch from a to b, which begins or ends at the contact point where one of them is a wall.
/// @param area of the assembly [m^2]; @param thickness [m]
/// Throws InvalidInput unless both are above 0 and the sum is finite.
template <class Contacts, Execution E = Serial>
[[nodiscard]] Stress2 average_stress(const Contacts& contacts, double area, double thickness,
                                     const E& execution = {}) {
  require_positive("average_stress: area", area);
  require_positive("average_stress: thickness", thickness);
  const Stress2 sum = internal::sum_of_stresses(
      contacts, [](const auto& c) { return symmetric_product(c.force_on_b(), c.branch()); },
      execution);
  internal::require_finite_sum(sum);
  return (1 / (area * thickness)) * sum;
}

/// An ellipse with its axes along axes 1 and 2.
struct Ellipse {
  Vec2 semi_axes{0, 0};  ///< [m]
  Vec2 centre{0, 0};     ///< [m]

  [[nodiscard]] double area() const { return std::numbers::pi * semi_axes.x() * semi_axes.y(); }

  /// Share of the segment from p to q that lies inside [-].
  [[nodiscard]] double share_inside(const Vec2& p, const Vec2& q) const;
};

/// The same average over the material inside an ellipse: each contact counts with the share of its
/// branch that lies inside. Free of the boundary's own effects.
template <class Contacts>
[[nodiscard]] Stress2 average_stress_within(const Contacts& contacts, const Ellipse& region,
                                            double thickness) {
  require_positive("average_stress_within: area", region.area());
  require_positive("average_stress_within: thickness", thickness);
  const Stress2 sum = internal::sum_of_stresses(contacts, [&](const auto& c) {
    const double share = region.share_inside(c.geometry.point - c.branch_arm_a(),
                                             c.geometry.point - c.branch_arm_b());
    return symmetric_product(c.force_on_b(), share * c.branch());
  });
  internal::require_finite_sum(sum);
  return (1 / (region.area() * thickness)) * sum;
}

/// Eq. 12 for a test that loads axis 2: (sigma_22 - sigma_11) / (sigma_22 + sigma_11); 0 where
/// there is no stress.
[[nodiscard]] double sin_phi(const Stress2& stress);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/measurement/average_stress.ipp>
#endif
