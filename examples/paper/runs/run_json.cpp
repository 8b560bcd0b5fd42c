// SPDX-License-Identifier: BSL-1.0
// Curve, grading, energy and numbers of a run, as run.json has them.

#include "run_json.hpp"

#include <algorithm>
#include <cmath>

#include "../../biaxial/grading_json.hpp"

namespace study {

namespace {

using Point = riprap::CurvePoint;

// Not a number if any is not: it is null in the file.
template <class Value>
double largest(const riprap::Curve& curve, double from_strain, Value value) {
  double most = 0;
  for (const Point& p : curve.points()) {
    if (p.axial_strain < from_strain) continue;
    const auto v = static_cast<double>(value(p));
    if (std::isnan(v)) return v;
    most = std::max(most, v);
  }
  return most;
}

}  // namespace

Json curve_json(const riprap::Curve& curve) {
  Json j;
  const auto column = [&](const char* name, auto value) {
    Json& values = j[name] = Json::array();
    for (const Point& p : curve.points()) values.push_back(value(p));
  };
  column("axial_strain", [](const Point& p) { return p.axial_strain; });
  column("volumetric_strain", [](const Point& p) { return p.volumetric_strain; });
  column("porosity", [](const Point& p) { return p.porosity; });
  column("sigma_11_Pa", [](const Point& p) { return p.stress.s11; });
  column("sigma_22_Pa", [](const Point& p) { return p.stress.s22; });
  column("sin_phi", [](const Point& p) { return p.sin_phi(); });
  column("sin_phi_inner", [](const Point& p) { return p.inner_sin_phi(); });
  column("sin_phi_eq_14", [](const Point& p) { return p.sin_phi_fabric(); });
  column("sin_phi_eq_15", [](const Point& p) { return p.sin_phi_fabric_simplified(); });
  column("sin_phi_full", [](const Point& p) { return p.sin_phi_fabric_full(); });
  column("a", [](const Point& p) { return p.fabric.normals.coefficient; });
  column("a_n", [](const Point& p) { return p.fabric.normal_forces.coefficient; });
  column("a_t", [](const Point& p) { return p.fabric.tangential_forces.coefficient; });
  column("b_n", [](const Point& p) { return p.fabric.normal_branches.coefficient; });
  column("b_t", [](const Point& p) { return p.fabric.tangential_branches.coefficient; });
  column("coordination_number", [](const Point& p) { return p.coordination.coordination_number; });
  column("contacts_per_particle",
         [](const Point& p) { return p.coordination.contacts_per_particle; });
  column("breakages", [](const Point& p) { return p.breakages; });
  column("overlap_ratio", [](const Point& p) { return p.overlap_ratio; });
  column("inertial_number", [](const Point& p) { return p.inertial_number; });
  column("kinetic_ratio", [](const Point& p) { return p.state.kinetic_ratio(); });
  column("lost_particles", [](const Point& p) { return p.lost_particles; });
  return j;
}

Json grading_json(const riprap::Particles& particles) {
  constexpr int sizes = 60;
  const riprap::Grading before = riprap::grading_before_breakage(particles);
  const riprap::Grading after = riprap::grading(particles);
  const double finest = after.points().front().size;
  const double ratio = before.largest() / finest;
  Json j = {
      {"size_m", Json::array()}, {"finer_before", Json::array()}, {"finer_after", Json::array()}};
  for (int k = 0; k <= sizes; ++k) {
    const double size = k == sizes ? before.largest() : finest * std::pow(ratio, k / double{sizes});
    j["size_m"].push_back(size);
    j["finer_before"].push_back(before.passing(size));
    j["finer_after"].push_back(after.passing(size));
  }
  j.update(indices_json(before, after));
  return j;
}

Json numbers_json(const riprap::Curve& curve, const riprap::BiaxialResult& result, double kappa) {
  return {
      {"kappa", kappa},
      {"inertial_number_largest",
       largest(curve, 0, [](const Point& p) { return p.inertial_number; })},
      {"overlap_ratio_largest", largest(curve, 0, [](const Point& p) { return p.overlap_ratio; })},
      {"kinetic_ratio_largest_after_1_percent",
       largest(curve, 0.01, [](const Point& p) { return p.state.kinetic_ratio(); })},
      {"lost_particles", largest(curve, 0, [](const Point& p) { return p.lost_particles; })},
      {"confinement_error_mean", result.mean_confinement_error},
      {"energy_error", curve.points().back().energy_error()}};
}

Json energy_json(const riprap::Curve& curve) {
  const riprap::EnergyTerms& e = curve.points().back().energy;
  return {{"boundary_work_J", e.boundary_work},
          {"kinetic_J", e.kinetic},
          {"stored_J", e.stored},
          {"slip_J", e.slip},
          {"damping_J", e.damping},
          {"breakage_J", e.breakage},
          {"law_residual_J", e.law_residual},
          {"unclosed_J", e.unclosed()}};
}

Json stages_json(const riprap::BiaxialResult& result) {
  Json stages = Json::array();
  for (std::size_t i = 0; i < result.stages.size(); ++i)
    stages.push_back({{"stage", riprap::to_text(static_cast<riprap::Stage>(i))},
                      {"steps", result.stages[i].steps},
                      {"reached_target", result.stages[i].reached_target},
                      {"wall_s", result.stages[i].wall_seconds}});
  return stages;
}

}  // namespace study
