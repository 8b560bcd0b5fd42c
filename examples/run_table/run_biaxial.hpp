// SPDX-License-Identifier: BSL-1.0
#pragma once
// One biaxial test with any model.

#include <algorithm>
#include <ctime>
#include <vector>

#include <riprap/riprap.hpp>

#include "biaxial_numbers.hpp"
#include "biaxial_setup.hpp"

namespace run_table {

namespace internal {

[[nodiscard]] inline double mean_sin_phi(const std::vector<riprap::CurvePoint>& points, double from,
                                         double to) {
  double sum = 0;
  double count = 0;
  for (const auto& p : points)
    if (p.axial_strain >= from - 1e-4 && p.axial_strain <= to + 1e-4) {
      sum += p.sin_phi();
      ++count;
    }
  return sum / count;
}

// Processor time of this thread [s].
[[nodiscard]] inline double thread_seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace internal

template <class ModelType>
[[nodiscard]] BiaxialNumbers run_biaxial(const ModelType& model, const Setup& setup) {
  using namespace riprap;
  Simulation sim{model, random_assembly({.count = setup.particles, .seed = setup.seed}), Rock{}};
  Curve curve;
  const double begin = internal::thread_seconds();
  BiaxialTest{.confining_pressure = setup.pressure,
              .axial_strain = setup.strain,
              .inertial_number = setup.inertial_number}
      .run(sim, curve);
  const double seconds = internal::thread_seconds() - begin;
  const auto& points = curve.points();
  const CurvePoint& end = points.back();
  BiaxialNumbers r;
  for (const CurvePoint& p : points)
    r.peak = std::max(r.peak,
                      internal::mean_sin_phi(points, p.axial_strain - 0.01, p.axial_strain + 0.01));
  r.residual = internal::mean_sin_phi(points, 0.75 * setup.strain, setup.strain);
  r.volumetric_strain = end.volumetric_strain;
  r.coordination = end.coordination.contacts_per_particle * 2;
  r.breakages = static_cast<double>(curve.breaks().size());
  const double work = end.energy.boundary_work;
  r.law = end.energy.law_residual / work;
  r.splitting = end.energy.breakage / work;
  r.damping = end.energy.damping / work;
  r.made = end.energy.made() / work;
  r.overlap = end.overlap_ratio;
  r.step_time = 1e6 * seconds / static_cast<double>(sim.steps());
  return r;
}

}  // namespace run_table
