// SPDX-License-Identifier: BSL-1.0
#pragma once
// A biaxial test of a compacted sample with one model, and what is kept of it.

#include <ctime>

#include <riprap/experiment/biaxial_test.hpp>
#include <riprap/experiment/brazilian_test.hpp>
#include <riprap/experiment/curve.hpp>
#include <riprap/measurement/breakage_indices.hpp>
#include <riprap/measurement/grading.hpp>
#include <riprap/simulation/simulation.hpp>

#include "models.hpp"

namespace rivals {

// Of the calling thread.
inline double processor_seconds() {
#ifdef CLOCK_THREAD_CPUTIME_ID
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
#else
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
#endif
}

// What the strengths of a model are multiplied by, so that a disc has the Brazilian strength of the
// case: load and strengths are proportional in all models.
template <class ModelType>
double strength_factor(const ModelType& model, const Case& c) {
  const riprap::BrazilianTest disc{.diameter = c.diameter, .thickness = c.sample.thickness};
  return c.strength / disc.strength(model, riprap::Rock{});
}

// The path of a biaxial test behind its compaction.
inline riprap::LoadingPath<> shear_path(const Case& c) {
  riprap::LoadingPath<> path =
      riprap::BiaxialTest{.confining_pressure = c.pressure, .axial_strain = c.strain}.path();
  path.stages.erase(path.stages.begin());
  return path;
}

inline Json to_json(const riprap::Grading& grading) {
  Json points = Json::array();
  for (const double share : {0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0})
    points.push_back({grading.size_at(share), share});
  return points;
}

template <class ModelType>
Json run_model(const ModelType& model, const Case& c) {
  using namespace riprap;
  const double begun = processor_seconds();
  Simulation sim{model, c.sample, Rock{}};
  Curve curve;
  const PathResult result = shear_path(c).run(sim, curve);
  const Grading before = grading_before_breakage(sim.particles());
  const Grading after = grading(sim.particles());
  Json j;
  j["seconds"] = processor_seconds() - begun;
  j["steps"] = sim.steps();
  j["time_step_s"] = sim.time_step();
  j["bodies"] = sim.particles().size();
  j["reached_target"] = result.stages.back().reached_target;
  j["breakages_before_shear"] = curve.breakages_before_shear();
  j["peak_sin_phi"] = curve.peak().sin_phi();
  j["hardin_breakage"] = hardin_breakage(before, after);
  j["energy_error"] = curve.points().back().energy_error();
  j["breakage_loss_share"] =
      curve.points().back().energy.breakage / curve.points().back().energy.boundary_work;
  for (const CurvePoint& p : curve.points())
    j["curve"].push_back({p.axial_strain, p.sin_phi(), p.volumetric_strain,
                          p.coordination.contacts_per_particle, p.breakages});
  j["grading_before"] = to_json(before);
  j["grading_after"] = to_json(after);
  return j;
}

}  // namespace rivals
