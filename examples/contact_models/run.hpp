// SPDX-License-Identifier: BSL-1.0
#pragma once
// One biaxial test with a contact model, and the numbers that are compared.

#include <algorithm>
#include <array>
#include <cstdint>
#include <ctime>
#include <string>
#include <vector>

#include <riprap/riprap.hpp>

namespace contact_models {

struct Setup {
  double pressure = 8e6;  // [Pa]
  std::uint64_t seed = 1;
  unsigned particles = 500;
  double strain = 0.2;
};

// Energies as shares of the boundary work of shear.
struct Result {
  double peak = 0;               // sin phi, mean over 2 % of strain
  double residual = 0;           // sin phi, mean over the last quarter
  double volumetric_strain = 0;  // at the end, contraction positive
  double coordination = 0;       // 2 M / N at the end
  double breakages = 0;
  double law = 0;        // energy that the law cannot explain; made: negative
  double splitting = 0;  // energy lost in breaks; made: negative
  double damping = 0;
  double overlap = 0;    // mean depth over mean diameter
  double step_time = 0;  // processor time of a step [us]
  double made = 0;       // energy made by law and splitting together
};

// Names of the numbers, for files and tables.
struct Column {
  const char* name;
  double Result::*value;
};
inline constexpr std::array<Column, 11> columns{{{"peak_sin_phi", &Result::peak},
                                                 {"residual_sin_phi", &Result::residual},
                                                 {"volumetric_strain", &Result::volumetric_strain},
                                                 {"coordination", &Result::coordination},
                                                 {"breakages", &Result::breakages},
                                                 {"law_share", &Result::law},
                                                 {"splitting_share", &Result::splitting},
                                                 {"damping_share", &Result::damping},
                                                 {"overlap_ratio", &Result::overlap},
                                                 {"step_time_us", &Result::step_time},
                                                 {"made_share", &Result::made}}};

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

template <class ModelType>
Result run(const ModelType& model, const Setup& setup) {
  using namespace riprap;
  Simulation sim{model, random_assembly({.count = setup.particles, .seed = setup.seed}), Rock{}};
  Curve curve;
  const double begin = thread_seconds();
  BiaxialTest{.confining_pressure = setup.pressure, .axial_strain = setup.strain}.run(sim, curve);
  const double seconds = thread_seconds() - begin;
  const auto& points = curve.points();
  const CurvePoint& end = points.back();
  Result r;
  for (const CurvePoint& p : points)
    r.peak = std::max(r.peak, mean_sin_phi(points, p.axial_strain - 0.01, p.axial_strain + 0.01));
  r.residual = mean_sin_phi(points, 0.75 * setup.strain, setup.strain);
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

// Compiled each by itself.
Result run_chord(const Setup& setup);
Result run_incremental(const Setup& setup);
Result run_area(const Setup& setup);
Result run_moments(const Setup& setup);

}  // namespace contact_models
