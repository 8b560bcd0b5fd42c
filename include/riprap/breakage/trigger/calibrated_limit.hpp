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
    {25, 0.245}, {50, 0.285}, {100, 0.328}, {200, 0.353}, {400, 0.371}};
inline constexpr CalibratedLimit linear_strain_limits[] = {
    {52, 0.336}, {100, 0.364}, {200, 0.377}, {400, 0.386}};

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
/// load that 0.4 gives on a very fine mesh: 0.245 at 25 sampling points, 0.285 at 50, 0.328 at 100,
/// 0.353 at 200, 0.371 at 400, linear in the logarithm of their number in between.
///
/// The median of 1,180 intact particles under the loads of biaxial tests at 2, 8 and 14 MPa:
/// HoekBrown with Table 1's rock, PlaneStress, InertiaRelief, UniformMesher. docs/convergence.md
/// has each pressure, pieces and other rocks.
/// @param samples  sampling points asked for, 25 to 400: the number of triangles of the mesher
/// Throws InvalidInput outside this range.
[[nodiscard]] inline double calibrated_limit(const ConstantStrainTriangle&, std::size_t samples) {
  return internal::interpolate_limit(internal::constant_strain_limits, samples);
}

/// The same for six-node triangles sampled at four points: 0.336 at 52 sampling points, 0.364 at
/// 100, 0.377 at 200, 0.386 at 400.
/// @param samples  sampling points asked for, 52 to 400: four times the number of triangles
/// Throws InvalidInput outside this range.
[[nodiscard]] inline double calibrated_limit(const LinearStrainTriangle&, std::size_t samples) {
  return internal::interpolate_limit(internal::linear_strain_limits, samples);
}

}  // namespace riprap
