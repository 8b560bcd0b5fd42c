#pragma once
// The summary of a biaxial test: every parameter and dimensionless number, peaks, counts, times.

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "options.hpp"

// Keeps the order in which things are written.
using Json = nlohmann::ordered_json;

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

template <class Sim>
Json parameters_json(const Options& o, const Sim& sim, const riprap::BiaxialTest& test) {
  const auto& law = sim.contacts().law();
  Json j = {{"particles", o.particles},
            {"seed", o.seed},
            {"confining_pressure_Pa", o.pressure},
            {"axial_strain", o.strain},
            {"mean_diameter_m", o.mean_diameter},
            {"thickness_m", o.thickness},
            {"vertices", {o.fewest_vertices, o.most_vertices}},
            {"density_kg_m3", sim.rock().density},
            {"young_Pa", sim.rock().young},
            {"poisson", sim.rock().poisson},
            {"normal_stiffness_N_m", law.normal_stiffness},
            {"tangential_stiffness_N_m", law.tangential_stiffness},
            {"friction", law.friction},
            {"local_damping", sim.model().motion_model.damping.coefficient},
            {"time_step_s", sim.time_step()},
            {"inertial_number", o.inertial_number},
            {"jam_pressure_Pa", test.jam_pressure},
            {"jam_kinetic_ratio", test.jam_kinetic_ratio},
            {"compaction_inertial_number", test.compaction_inertial_number},
            {"rest_unbalanced_force", test.rest_unbalanced_force},
            {"hydrostatic_tolerance", test.hydrostatic_tolerance},
            {"hydrostatic_unbalanced_force", test.hydrostatic_unbalanced_force},
            {"breakage", o.breakage}};
  if (!o.breakage) return j;
  const riprap::HoekBrown hoek_brown;
  const riprap::MohrCoulomb mohr_coulomb;
  j["criterion"] = o.criterion;
  if (o.criterion == "hoek-brown")
    j["strength"] = {{"compressive_strength_Pa", hoek_brown.compressive_strength},
                     {"m_b", hoek_brown.m_b},
                     {"s", hoek_brown.s},
                     {"a_b", hoek_brown.a_b}};
  else
    j["strength"] = {{"cohesion_Pa", mohr_coulomb.cohesion},
                     {"angle_rad", mohr_coulomb.angle},
                     {"tension_Pa", mohr_coulomb.tension}};
  j["line_fit"] = o.line_fit;
  j["support"] = o.support;
  j["plane"] = o.plane;
  j["mesh_triangles"] = o.mesh_triangles;
  j["ratf"] = o.ratf;
  j["check_every"] = o.check_every;
  j["minimum_piece_area"] = o.minimum_piece_area;
  j["maximum_piece_aspect"] = o.maximum_piece_aspect;
  return j;
}

// The largest of a value over the curve from a strain on.
template <class Value>
double largest(const riprap::Curve& curve, double from_strain, Value value) {
  double most = 0;
  for (const riprap::CurvePoint& p : curve.points())
    if (p.axial_strain >= from_strain) most = std::max(most, static_cast<double>(value(p)));
  return most;
}

template <class Sim>
Json numbers_json(const Options& o, const Sim& sim, const riprap::BiaxialResult& result,
                  const riprap::Curve& curve) {
  using P = riprap::CurvePoint;
  const auto& law = sim.contacts().law();
  const double mass_time = std::sqrt(sim.smallest_mass() / law.peak_stiffness());
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
      {"kappa", riprap::stiffness_level(o.pressure, o.thickness, law.normal_stiffness)},
      {"pressure_over_compressive_strength",
       o.pressure / chosen_criterion(o).major_stress_at_failure(0)},
      {"time_step_over_sqrt_m_k", sim.time_step() / mass_time},
      {"axial_rate_1_s", result.axial_rate},
      {"inertial_number_largest",
       largest(curve, 0, [](const P& p) { return p.inertial_number; })},
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

template <class Sim>
Json summary(const Options& o, const Sim& sim, const riprap::BiaxialTest& test,
             const riprap::BiaxialResult& result, const riprap::Curve& curve,
             const riprap::RangeCheck& ranges) {
  Json stages = Json::array();
  for (std::size_t i = 0; i < result.stages.size(); ++i)
    stages.push_back({{"stage", riprap::to_text(static_cast<riprap::Stage>(i))},
                      {"steps", result.stages[i].steps},
                      {"reached_target", result.stages[i].reached_target},
                      {"wall_s", result.stages[i].wall_seconds}});
  return {{"riprap", riprap::version},
          {"parameters", parameters_json(o, sim, test)},
          {"numbers", numbers_json(o, sim, result, curve)},
          {"peak", point_json(curve.peak())},
          {"end", point_json(curve.points().back())},
          {"counts",
           {{"particles", sim.particles().size()},
            {"breakages", sim.breaks().size()},
            {"breakages_before_shear", curve.breakages_before_shear()}}},
          {"energy_error", curve.points().back().energy_error()},
          {"stages", stages},
          {"warnings", ranges.warnings()}};
}

inline void print_summary(const riprap::Curve& curve, const std::string& folder) {
  const riprap::CurvePoint& peak = curve.peak();
  const riprap::CurvePoint& end = curve.points().back();
  std::printf(
      "peak sin phi %.3f at %.1f %% strain; at the end sin phi %.3f, volumetric strain %.2f %%,\n"
      "coordination %.2f, %zu breakages in shear, %zu before\n"
      "results in %s: curves.svg, assembly_before.svg, assembly_after.svg, forces_before.svg,\n"
      "forces_after.svg, curve.csv, energy.csv, breakages.csv, summary.json\n",
      peak.sin_phi(), 100 * peak.axial_strain, end.sin_phi(), 100 * end.volumetric_strain,
      end.coordination.coordination_number, end.breakages, curve.breakages_before_shear(),
      folder.c_str());
}
