// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Stiffness of a sample from its curve of stress against strain.

#include <algorithm>
#include <cstddef>
#include <span>

#include <riprap/core/errors.hpp>
#include <riprap/core/linkage.hpp>
#include <riprap/core/vec2.hpp>

namespace riprap {

/// Slope of the line from the start of loading to a point of the curve of deviator against axial
/// strain. In a biaxial test, plane strain under constant sigma_3, the deviator is sigma_1 -
/// sigma_3 and the axis is that of sigma_1: for an elastic material the slope is E/(1 - nu^2), not
/// E as in a triaxial test.
struct SecantModulus {
  double modulus = 0;       ///< [Pa]
  double axial_strain = 0;  ///< since the start of loading [-]
  double deviator = 0;      ///< since the start of loading [Pa]
};

namespace internal {}  // namespace internal

/// At a share of the largest deviator: E_50 of a share of one half, which it is by default. The
/// deviator counts from the first point, and the point is where the curve, straight between its
/// points, first reaches the share. Throws InvalidInput if strains do not ascend or the deviator
/// never exceeds the first one.
/// @param curve axial strain [-] and deviator [Pa], compression positive
/// @param share in (0, 1]
[[nodiscard]] SecantModulus secant_modulus_at_share(std::span<const Vec2> curve,
                                                    double share = 0.5);

/// At an axial strain [-] since the first point, which is above 0 and lies on the curve. Throws
/// InvalidInput otherwise.
[[nodiscard]] SecantModulus secant_modulus_at_strain(std::span<const Vec2> curve, double strain);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/measurement/secant_modulus.ipp>
#endif
