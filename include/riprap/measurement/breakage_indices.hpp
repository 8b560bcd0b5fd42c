// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// How much finer a sample has become: the indices of Marsal, Hardin, Lade and Einav. All are
/// shares [-], zero where nothing broke.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include <riprap/core/errors.hpp>
#include <riprap/core/linkage.hpp>
#include <riprap/measurement/grading.hpp>

namespace riprap {

/// Relative breakage B_r = B_t / B_p of Hardin (1985): the area between the two curves over the
/// area between the first one and `limit`. One when all is as fine as the limit.
/// @param limit size to which grains could be crushed [m]; finer ones do not count
[[nodiscard]] double hardin_breakage(const Grading& before, const Grading& after,
                                     double limit = 0.074e-3);

/// B_g of Marsal (1967), who gives it in per cent: the sum of what the intervals between sieves
/// have gained, the one below the finest sieve and the one above the coarsest included.
/// @param sieves openings [m], ascending
[[nodiscard]] double marsal_breakage(const Grading& before, const Grading& after,
                                     std::span<const double> sieves);

/// B_10 = 1 - D10 after / D10 before of Lade, Yamamuro and Bopp (1996).
[[nodiscard]] double lade_breakage(const Grading& before, const Grading& after);

/// The fractal grading that crushing tends to: F = (d / d_M)^exponent from d_m up to the largest
/// grain d_M. In space, where mass goes with d^3, the exponent is 3 - alpha with a fractal
/// dimension alpha near 2.6. In the plane mass goes with d^2 and the exponent is 2 - alpha_2; a
/// plane section of the sample in space has alpha_2 = alpha - 1, hence the same exponent.
struct UltimateGrading {
  double exponent = 0.4;         ///< [-]
  double smallest_ratio = 1e-4;  ///< d_m / d_M [-]; finer grains count as d_m

  /// Area above d_m, over the decimal logarithm of size [-].
  [[nodiscard]] double area() const;
  void validate() const;
};

/// B_r of Einav (2007): the area between the two curves over the area between the first one and the
/// ultimate one. One for the ultimate grading.
[[nodiscard]] double einav_breakage(const Grading& before, const Grading& after,
                                    const UltimateGrading& ultimate = {});

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/measurement/breakage_indices.ipp>
#endif
