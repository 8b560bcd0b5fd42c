// SPDX-License-Identifier: BSL-1.0
#pragma once
// The study as JSON.

#include <cmath>

#include "claims.hpp"

namespace unconfined {

inline Json sweep_json(const Sweep& s) {
  Json points = Json::array();
  for (const auto& p : s.points) points.push_back({p.x(), p.y()});
  return {{"parameter", s.parameter}, {"value_and_Rat", points}};
}

inline Json options_json(const Options& o) {
  return {{"width_m", o.width},
          {"aspect", o.aspect},
          {"poisson", o.poisson},
          {"young_Pa", o.young},
          {"strength_Pa", o.strength},
          {"m_b", o.m_b},
          {"friction", std::isfinite(o.friction) ? Json(o.friction) : Json("rough")},
          {"load", o.load},
          {"triangles", o.triangles},
          {"criterion", o.criterion},
          {"plane", o.plane}};
}

inline Json specimen_json(const Specimen& s) {
  const riprap::UnconfinedResult& r = s.result;
  Json lines = Json::array();
  for (const FailureLine& line : s.lines)
    lines.push_back({{"fit", line.fit}, {"to_axis_degrees", line.angle()}});
  return {{"Rat", r.ratio()},
          {"elements", r.failures.elements},
          {"failed", r.failures.failed},
          {"tensile", r.tensile},
          {"shear", r.shear},
          {"lowest_safety_factor", r.failures.lowest_safety_factor},
          {"platen_stress_Pa", r.platen_stress},
          {"axial_strain", r.axial_strain},
          {"stiffness_over_young", r.platen_stress / r.axial_strain / s.options.young},
          {"slipping_platen_nodes", r.slipping_nodes()},
          {"platen_nodes", r.platen_nodes.size()},
          {"least_normal_force_N", r.least_normal_force()},
          {"first_failed_plane_to_axis_degrees", s.plane_angle},
          {"failure_lines", lines}};
}

inline Json claims_json(const Study& s) {
  Json out = Json::array();
  for (const Claim& c : claims(s))
    out.push_back({{"name", c.name},
                   {"rule", c.rule},
                   {"number", c.number},
                   {"verdict", c.verdict},
                   {"reason", c.reason}});
  return out;
}

inline Json to_json(const Study& s) {
  Json poisson = Json::array();
  for (const PoissonSweep& p : s.poisson) {
    Json entry = sweep_json(p.sweep);
    entry["m_b"] = p.m_b;
    poisson.push_back(entry);
  }
  Json others = Json::array();
  for (const Sweep& sweep : s.others) others.push_back(sweep_json(sweep));
  return {{"options", options_json(s.options)},
          {"specimen", specimen_json(s.specimen)},
          {"mean_Rat_over_poisson_and_m_b", mean_ratio(s)},
          {"load_at_Rat_0.4", s.load_at_0_4},
          {"paper", {{"RatF_range", {paper_low, paper_high}}, {"RatF_mean", paper_mean}}},
          {"poisson", poisson},
          {"young", sweep_json(s.young)},
          {"strength", sweep_json(s.strength)},
          {"others", others},
          {"claims", claims_json(s)}};
}

}  // namespace unconfined
