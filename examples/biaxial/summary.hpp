// SPDX-License-Identifier: BSL-1.0
#pragma once
// The summary of a biaxial test: parameters, dimensionless numbers, peaks, counts, times.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "grading_json.hpp"
#include "parameters_json.hpp"
#include "result_files.hpp"

inline Json point_json(const riprap::CurvePoint& p) {
  return {{"axial_strain", p.axial_strain},
          {"volumetric_strain", p.volumetric_strain},
          {"sin_phi", p.sin_phi()},
          {"sin_phi_inner", p.inner_sin_phi()},
          {"sin_phi_fabric", p.sin_phi_fabric()},
          {"sin_phi_fabric_simplified", p.sin_phi_fabric_simplified()},
          {"sin_phi_fabric_full", p.sin_phi_fabric_full()},
          {"a", p.fabric.normals.coefficient},
          {"a_n", p.fabric.normal_forces.coefficient},
          {"a_t", p.fabric.tangential_forces.coefficient},
          {"coordination_number", p.coordination.coordination_number},
          {"contacts_per_particle", p.coordination.contacts_per_particle},
          {"porosity", p.porosity}};
}

// The largest of a value over the curve from a strain on; not a number if any is not.
template <class Value>
double largest(const riprap::Curve& curve, double from_strain, Value value) {
  double most = 0;
  for (const riprap::CurvePoint& p : curve.points()) {
    const auto v = static_cast<double>(value(p));
    if (std::isnan(v)) return v;
    if (p.axial_strain >= from_strain) most = std::max(most, v);
  }
  return most;
}

template <class Sim>
Json numbers_json(const Options& o, const Sim& sim, const riprap::BiaxialResult& result,
                  const riprap::Curve& curve) {
  using P = riprap::CurvePoint;
  const auto& law = sim.contacts().law();
  double fabric_gap = 0;
  double simplified_gap = 0;
  double full_gap = 0;
  const auto count = static_cast<double>(curve.points().size());
  for (const P& p : curve.points()) {
    fabric_gap += std::abs(p.sin_phi_fabric() - p.sin_phi()) / count;
    simplified_gap += std::abs(p.sin_phi_fabric_simplified() - p.sin_phi()) / count;
    full_gap += std::abs(p.sin_phi_fabric_full() - p.sin_phi()) / count;
  }
  Json j = {
      {"kappa", riprap::stiffness_level(o.test.confining_pressure, o.assembly.thickness,
                                        law.peak_stiffness())},
      {"pressure_over_compressive_strength",
       o.test.confining_pressure / chosen_criterion(o).major_stress_at_failure(0)},
      {"time_step_over_sqrt_m_k",
       riprap::time_step_ratio(sim.time_step(), sim.particles(), law.peak_stiffness())},
      {"axial_rate_1_s", result.axial_rate},
      {"inertial_number_largest", largest(curve, 0, [](const P& p) { return p.inertial_number; })},
      {"overlap_ratio_largest", largest(curve, 0, [](const P& p) { return p.overlap_ratio; })},
      {"kinetic_ratio_largest_after_1_percent",
       largest(curve, 0.01, [](const P& p) { return p.state.kinetic_ratio(); })},
      {"unbalanced_force_largest_after_1_percent",
       largest(curve, 0.01, [](const P& p) { return p.state.unbalanced_force; })},
      {"lost_particles", largest(curve, 0, [](const P& p) { return p.lost_particles; })},
      {"confinement_error_mean", result.mean_confinement_error},
      {"confinement_error_rms", result.rms_confinement_error},
      {"mean_gap_eq_14", fabric_gap},
      {"mean_gap_eq_15", simplified_gap},
      {"mean_gap_full_relation", full_gap},
  };
  return j;
}

// Indices of breakage, and Hardin's if all rock were in pieces of the least area: the largest value
// that pieces which are simulated can reach.
template <class Sim>
Json grading_json(const Sim& sim) {
  using namespace riprap;
  const Particles& particles = sim.particles();
  const Grading before = grading_before_breakage(particles);
  const Grading after = grading(particles);
  Json j = {{"d10_m", {before.size_at(0.10), after.size_at(0.10)}},
            {"d50_m", {before.size_at(0.50), after.size_at(0.50)}},
            {"dust_pieces", particles.dust().size()},
            {"dust_share", particles.dust_area() / rock_area(particles)}};
  j.update(indices_json(before, after));
  if constexpr (Sim::breakable)
    j["hardin_b_r_of_smallest_pieces"] = index_json([&] {
      const double area = sim.model().breakage_model.splitter.minimum_area * sim.mean_area();
      return hardin_breakage(before, Grading::of_fractions({{equivalent_diameter(area), 1}}));
    });
  return j;
}

inline Json stages_json(const riprap::BiaxialResult& result) {
  Json stages = Json::array();
  for (std::size_t i = 0; i < result.stages.size(); ++i)
    stages.push_back({{"stage", riprap::to_text(static_cast<riprap::Stage>(i))},
                      {"steps", result.stages[i].steps},
                      {"reached_target", result.stages[i].reached_target},
                      {"servo_saturated_steps", result.stages[i].saturated_steps},
                      {"wall_s", result.stages[i].wall_seconds}});
  return stages;
}

// Every number that was checked, beside its limit.
inline Json checks_json(const riprap::CheckTable& table) {
  Json checks = Json::array();
  for (const riprap::CheckedNumber& n : table.rows())
    checks.push_back({{"name", n.name},
                      {"worst", n.measured ? Json(n.worst) : Json(nullptr)},
                      {n.is_upper_limit ? "at_most" : "at_least", n.limit},
                      {"holds", n.holds()},
                      {"stage", riprap::to_text(n.stage)},
                      {"axial_strain", n.axial_strain},
                      {"beyond_the_limit", n.reason}});
  return checks;
}

inline void print_checks(const riprap::CheckTable& table) {
  std::printf("%zu of %zu checks hold\n", table.rows().size() - table.violations(),
              table.rows().size());
  for (const riprap::CheckedNumber& n : table.rows())
    if (!n.holds())
      std::printf("  %s: %.3g, should be %s %.3g (%s)\n", n.name.c_str(), n.worst,
                  n.is_upper_limit ? "at most" : "at least", n.limit, n.reason.c_str());
}

template <class Sim>
Json summary(const Options& o, const Sim& sim, const riprap::BiaxialResult& result,
             const riprap::Curve& curve, const riprap::ValidityCheck& check) {
  Json j = {{"riprap", riprap::version},
            {"status", result.interrupted ? "interrupted" : "finished"},
            {"parameters", parameters_json(o, sim)},
            {"numbers", numbers_json(o, sim, result, curve)},
            {"peak", nullptr},
            {"end", nullptr},
            {"counts",
             {{"particles", sim.particles().size()},
              {"breakages", sim.breaks().size()},
              {"breakages_before_shear", curve.breakages_before_shear()}}},
            {"grading_before_and_after", grading_json(sim)},
            {"energy_error", nullptr},
            {"stages", stages_json(result)},
            {"threads", sim.model().execution_policy.threads},
            {"checks", checks_json(check.table())},
            {"warnings", check.warnings()}};
  // They stay null if the run was interrupted before shear.
  if (!curve.points().empty()) {
    j["peak"] = point_json(curve.peak());
    j["end"] = point_json(curve.points().back());
    j["energy_error"] = curve.points().back().energy_error();
  }
  return j;
}

// Of a run that an error ended: its state is not to be trusted with more than this.
template <class Sim>
Json failure_summary(const Options& o, const Sim& sim, const std::vector<std::string>& warnings,
                     const std::string& error) {
  return {{"riprap", riprap::version},
          {"status", "failed"},
          {"error", error},
          {"parameters", parameters_json(o, sim)},
          {"warnings", warnings}};
}

template <class Sim>
void print_numbers(const Options& o, const Sim& sim, const riprap::Curve& curve) {
  const riprap::CurvePoint& peak = curve.peak();
  const riprap::CurvePoint& end = curve.points().back();
  const auto& law = sim.contacts().law();
  std::printf(
      "peak sin phi %.3f at %.1f %% strain; at the end sin phi %.3f, volumetric strain %.2f %%,\n"
      "coordination %.2f, %zu breakages in shear, %zu before\n",
      peak.sin_phi(), 100 * peak.axial_strain, end.sin_phi(), 100 * end.volumetric_strain,
      end.coordination.coordination_number, end.breakages, curve.breakages_before_shear());
  std::printf("kappa %.2g, overlap/d %.2g, inertial number %.2g, unbalanced force %.2g, "
              "dt/sqrt(m/k) %.2g\n",
              riprap::stiffness_level(o.test.confining_pressure, o.assembly.thickness,
                                      law.peak_stiffness()),
              end.overlap_ratio, end.inertial_number, end.state.unbalanced_force,
              riprap::time_step_ratio(sim.time_step(), sim.particles(), law.peak_stiffness()));
}

template <class Sim>
void print_summary(const Options& o, const Sim& sim, const riprap::BiaxialResult& result,
                   const riprap::Curve& curve) {
  if (result.interrupted)
    std::printf("interrupted %s; what was recorded until then is kept\n",
                curve.points().empty() ? "before shear" : "in shear");
  if (!curve.points().empty()) print_numbers(o, sim, curve);
  std::printf("results in %s: %s\n", o.out.c_str(), present_results(o.out).c_str());
}
