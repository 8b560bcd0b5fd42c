// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A criterion applied to the largest and the smallest of all three principal stresses.

#include <algorithm>

#include <riprap/breakage/criterion/concepts.hpp>
#include <riprap/core/errors.hpp>

namespace riprap {

/// By itself a criterion gets the two principal stresses in the plane. This one counts the stress
/// out of the plane as well: under compression from all sides in plane stress the smallest is 0,
/// and the confinement in the plane adds no strength.
template <Criterion C>
  requires(!MaterialCriterion<C>)  // put it into a CriterionOfRock instead
struct ThreePrincipalStresses {
  static constexpr bool never_fails = riprap::never_fails<C>;

  C criterion;
  /// Stress out of the plane over the sum of the two in it [-]: 0 in plane stress, Poisson's ratio
  /// of the rock in plane strain. It must be that of the plane state of the model.
  double out_of_plane = 0;

  [[nodiscard]] PrincipalValues extreme_stresses(const PrincipalValues& in_plane) const {
    const double third = out_of_plane * (in_plane.major + in_plane.minor);
    return {std::max(in_plane.major, third), std::min(in_plane.minor, third)};
  }
  [[nodiscard]] double major_stress_at_failure(double minor) const {
    return criterion.major_stress_at_failure(minor);
  }
  [[nodiscard]] double tensile_strength() const { return criterion.tensile_strength(); }
  [[nodiscard]] double friction_angle(double minor) const {
    return riprap::friction_angle(criterion, minor);
  }
  void validate() const {
    riprap::validate(criterion);
    require(out_of_plane >= 0 && out_of_plane < 0.5, "ThreePrincipalStresses.out_of_plane",
            out_of_plane, "must lie in [0, 0.5)");
  }
};

template <class C>
ThreePrincipalStresses(C, double = 0) -> ThreePrincipalStresses<C>;

}  // namespace riprap
