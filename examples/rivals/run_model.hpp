// SPDX-License-Identifier: BSL-1.0
#pragma once
// A biaxial test of a compacted sample with one model, and what is kept of it.

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <vector>

#include <riprap/experiment/biaxial_test.hpp>
#include <riprap/experiment/brazilian_test.hpp>
#include <riprap/experiment/curve.hpp>
#include <riprap/measurement/breakage_indices.hpp>
#include <riprap/measurement/fragments.hpp>
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

// Pairs of fragments that press on each other, per fragment, at each record.
struct PressedPairs {
  std::vector<double> per_fragment{};

  template <class Sim>
  void record(const riprap::LoadingView<Sim>& view) {
    auto pairs = riprap::loaded_fragment_contacts(view.sim);
    for (auto& pair : pairs) std::ranges::sort(pair);
    std::ranges::sort(pairs);
    const auto repeated = std::ranges::unique(pairs);
    pairs.erase(repeated.begin(), repeated.end());
    per_fragment.push_back(static_cast<double>(pairs.size()) /
                           static_cast<double>(riprap::fragments(view.sim).size()));
  }
};

template <class ModelType>
Json run_model(const ModelType& model, const Case& c) {
  using namespace riprap;
  const double begun = processor_seconds();
  Simulation sim{model, c.sample, Rock{}};
  Curve curve;
  PressedPairs pressed;
  const PathResult result = shear_path(c).run(sim, curve, pressed);
  const Grading before = grading_before_breakage(sim.particles());
  const Grading after = fragment_grading(sim);
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
  for (std::size_t k = 0; k < curve.points().size(); ++k) {
    const CurvePoint& p = curve.points()[k];
    j["curve"].push_back(
        {p.axial_strain, p.sin_phi(), p.volumetric_strain, pressed.per_fragment[k], p.breakages});
  }
  j["grading"] = to_json(after);
  return j;
}

}  // namespace rivals
