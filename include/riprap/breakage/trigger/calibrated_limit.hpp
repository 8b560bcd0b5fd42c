// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The limit on the failed area by which a coarse mesh breaks at the load of a very fine one.

#include <cmath>
#include <cstddef>
#include <iterator>
#include <span>

#include <riprap/core/errors.hpp>
#include <riprap/stress/element/constant_strain_triangle.hpp>
#include <riprap/stress/element/linear_strain_triangle.hpp>

namespace riprap {

namespace internal {

struct CalibratedLimit {
  double samples;  // sampling points asked for
  double limit;    // [-]
};

inline constexpr CalibratedLimit constant_strain_limits[] = {
    {25, 0.221}, {50, 0.280}, {100, 0.316}, {200, 0.348}, {400, 0.369}};
inline constexpr CalibratedLimit linear_strain_limits[] = {
    {50, 0.328}, {100, 0.354}, {200, 0.372}, {400, 0.385}};

[[nodiscard]] inline double interpolate_limit(std::span<const CalibratedLimit> table,
                                              std::size_t samples) {
  const auto at = static_cast<double>(samples);
  require(at >= table.front().samples && at <= table.back().samples,
          "calibrated_limit: sampling points", at,
          "must lie in [" + to_text(table.front().samples) + ", " + to_text(table.back().samples) +
              "], where the limit was measured");
  auto next = std::next(table.begin());
  while (at > next->samples) ++next;
  const CalibratedLimit& last = *std::prev(next);
  const double part = std::log(at / last.samples) / std::log(next->samples / last.samples);
  return last.limit + part * (next->limit - last.limit);
}

}  // namespace internal

/// FailedAreaRatio::critical [-] at which a particle of constant-strain triangles has the critical
/// load that 0.4 gives on a very fine mesh: 0.221 at 25 sampling points, 0.280 at 50, 0.316 at 100,
/// 0.348 at 200, 0.369 at 400, linear in the logarithm of their number in between.
///
/// Measured on particles under the loads of biaxial tests at 8 MPa: HoekBrown with Table 1's rock,
/// PlaneStress, InertiaRelief, UniformMesher. docs/convergence.md has other pressures and rocks.
/// @param samples  sampling points asked for, 25 to 400: the number of triangles of the mesher
/// Throws InvalidInput outside this range.
[[nodiscard]] inline double calibrated_limit(const ConstantStrainTriangle&, std::size_t samples) {
  return internal::interpolate_limit(internal::constant_strain_limits, samples);
}

/// The same for six-node triangles sampled at four points: 0.328 at 50 sampling points, 0.354 at
/// 100, 0.372 at 200, 0.385 at 400.
/// @param samples  sampling points asked for, 50 to 400: four times the number of triangles
/// Throws InvalidInput outside this range.
[[nodiscard]] inline double calibrated_limit(const LinearStrainTriangle&, std::size_t samples) {
  return internal::interpolate_limit(internal::linear_strain_limits, samples);
}

}  // namespace riprap
