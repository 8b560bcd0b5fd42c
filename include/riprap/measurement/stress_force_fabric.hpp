// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Strength from fabric: the right-hand sides of eqs 14 and 15, and the full relation with branch
/// vectors.

#include <cmath>
#include <numbers>

#include <riprap/core/linkage.hpp>
#include <riprap/core/stress2.hpp>
#include <riprap/measurement/fabric.hpp>

namespace riprap {

/// Eq. 14 (Rothenburg and Bathurst 1989): (a + a_n + a_t) / (2 + a a_n), coefficients projected on
/// `axis` [rad], the direction of the major stress. Exact for Fourier distributions and branches of
/// one length along the normal.
[[nodiscard]] double sin_phi_from_fabric(const Fabric& f, double axis);

/// Eq. 15: the same without the product in the denominator.
[[nodiscard]] double sin_phi_from_fabric_simplified(const Fabric& f, double axis);

/// The full relation: the stress tensor of the five Fourier distributions together, per contact,
/// sigma_ij = mean over theta of 2 pi E f_i l_j, symmetric part. Trigonometric polynomials of
/// degree eight: a sum over 16 directions is exact.
[[nodiscard]] Stress2 stress_from_fabric(const Fabric& f);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/measurement/stress_force_fabric.ipp>
#endif
