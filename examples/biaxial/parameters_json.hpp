// SPDX-License-Identifier: BSL-1.0
#pragma once
// Every parameter of a biaxial test, for the summary.

#include <cmath>
#include <nlohmann/json.hpp>
#include <variant>

#include "options.hpp"
#include "policies.hpp"
#include "setup_json.hpp"

// Keeps the order in which things are written.
using Json = nlohmann::ordered_json;

inline Json criterion_json(const riprap::HoekBrown& c) {
  return {{"name", "hoek-brown"},
          {"compressive_strength_Pa", c.compressive_strength},
          {"m_b", c.m_b},
          {"s", c.s},
          {"a_b", c.a_b},
          {"angle", c.angle == riprap::HoekBrown::Angle::tangent ? "tangent" : "equivalent"}};
}
inline Json criterion_json(const riprap::MohrCoulomb& c) {
  return {{"name", "mohr-coulomb"},
          {"cohesion_Pa", c.cohesion},
          {"angle_rad", c.angle},
          {"tension_Pa", c.tension}};
}
inline Json criterion_json(const riprap::Griffith& c) {
  return {{"name", "griffith"}, {"tension_Pa", c.tension}};
}
inline Json criterion_json(const riprap::ModifiedGriffith& c) {
  return {{"name", "modified-griffith"}, {"tension_Pa", c.tension}, {"friction", c.friction}};
}
inline Json criterion_json(const riprap::Murrell& c) {
  return {{"name", "murrell"}, {"tension_Pa", c.tension}};
}
inline Json criterion_json(const riprap::Hobbs& c) {
  return {{"name", "hobbs"},
          {"compressive_strength_Pa", c.compressive_strength},
          {"factor", c.factor},
          {"exponent", c.exponent},
          {"tension_Pa", c.tension}};
}
inline Json criterion_json(const riprap::Franklin& c) {
  return {{"name", "franklin"},
          {"compressive_strength_Pa", c.compressive_strength},
          {"exponent", c.exponent},
          {"tension_Pa", c.tension}};
}

inline Json criterion_json(const AnyCriterion& criterion) {
  return std::visit([](const auto& c) { return criterion_json(c); }, criterion.chosen);
}

inline Json trigger_json(const riprap::BrazilianStrength& t) {
  return {{"name", "brazilian"}, {"strength_Pa", t.strength}};
}
inline Json trigger_json(const riprap::MeanStressFailure&) { return {{"name", "mean-stress"}}; }
inline Json trigger_json(const riprap::HertzianStrength& t) {
  return {{"name", "hertz"}, {"pressure_Pa", t.pressure}};
}
inline Json trigger_json(const riprap::TsounguiStrength& t) {
  return {{"name", "tsoungui"}, {"strength_Pa", t.strength}};
}
inline Json trigger_json(const AnyLoadTrigger& trigger) {
  return std::visit([](const auto& t) { return trigger_json(t); }, trigger.trigger.chosen);
}
// Null where strengths do not scatter.
template <riprap::Trigger T>
Json scatter_json(const T& trigger) {
  if constexpr (riprap::HasStrengthFactor<T>)
    if (!std::isinf(trigger.modulus))
      return {{"name", "weibull"},
              {"modulus", trigger.modulus},
              {"dimension", trigger.dimension},
              {"reference_area_m2", trigger.reference_area},
              {"seed", trigger.seed}};
  return nullptr;
}

template <class Law>
Json springs_json(const char* name, const Law& law) {
  return {{"law", name},
          {"normal_stiffness_N_m", law.normal_stiffness},
          {"tangential_stiffness_N_m", law.tangential_stiffness},
          {"friction", law.friction}};
}
inline Json contact_json(const riprap::EnergyConservingSpring& law) {
  return springs_json("energy-conserving", law);
}
inline Json contact_json(const riprap::LinearSpringCoulomb& law) {
  return springs_json("linear", law);
}
inline Json contact_json(const riprap::IncrementalSpring& law) {
  return springs_json("incremental", law);
}
inline Json contact_json(const riprap::OverlapAreaSpring& law) {
  return {{"law", "area"},
          {"area_stiffness_N_m3", law.area_stiffness},
          {"largest_chord_m", law.largest_chord},
          {"tangential_stiffness_N_m", law.tangential_stiffness},
          {"friction", law.friction}};
}
inline Json contact_json(const riprap::SpringDashpot& law) {
  return {{"law", "dashpot"},
          {"normal_stiffness_N_m", law.normal_stiffness},
          {"tangential_stiffness_N_m", law.tangential_stiffness},
          {"damping_ratio", law.damping_ratio},
          {"may_pull", law.may_pull},
          {"friction", law.friction}};
}
// The files of the sample where they were given.
inline Json sample_json(const Options& o) {
  Json j = assembly_json(o.assembly);
  if (!o.grading.empty()) j["grading"] = o.grading;
  if (!o.outlines.empty()) j["outlines"] = o.outlines;
  return j;
}

inline Json contact_json(const AnyContact& law) {
  return std::visit([](const auto& l) { return contact_json(l); }, law.chosen);
}

template <class Sim>
Json breakage_json(const Options& o, const Sim& sim) {
  const auto& breakage = sim.model().breakage_model;
  Json j = {{"criterion", criterion_json(breakage.criterion)}};
  if constexpr (Sim::needs_elements) {
    j["ratf"] = breakage.trigger.critical;
    j["rat_measure"] = rat_measure(breakage.trigger);
  } else {
    j["trigger"] = trigger_json(breakage.trigger);
  }
  j["strength_scatter"] = scatter_json(breakage.trigger);
  j["line_fit"] = o.line_fit;
  j["minimum_piece_area"] = breakage.splitter.minimum_area;
  j["maximum_piece_aspect"] = breakage.splitter.maximum_aspect;
  j["maximum_pieces"] = breakage.splitter.maximum_pieces;
  j["dust"] = breakage.splitter.dust;
  j["check_every"] = breakage.check_every;
  return j;
}

// Every parameter, read from what was run.
template <class Sim>
Json parameters_json(const Options& o, const Sim& sim) {
  const auto& motion = sim.model().motion_model;
  Json contact = contact_json(sim.contacts().law());
  contact["relative_skin"] = sim.model().contact_model.broad_phase.relative_skin;
  Json j = {{"preset", o.preset},
            {"assembly", sample_json(o)},
            {"test", test_json(o.test)},
            {"rock",
             {{"density_kg_m3", sim.rock().density},
              {"young_Pa", sim.rock().young},
              {"poisson", sim.rock().poisson}}},
            {"contact", contact},
            {"motion",
             {{"boundary", o.boundary},
              {"integrator", o.integrator},
              {"local_damping", motion.damping.coefficient},
              {"time_step_fraction", motion.time_step.fraction},
              {"time_step_s", sim.time_step()}}}};
  j["breakage"] = "off";
  if constexpr (Sim::breakable) {
    if (o.breakage == "off") return j;
    if constexpr (Sim::needs_elements) {
      const auto& stress = sim.model().stress_model;
      j["stress"] = {{"plane", o.plane},
                     {"support", o.support},
                     {"mesh_triangles", stress.mesher.triangles},
                     {"nodes_of_triangle", stress.element.nodes}};
    }
    j["breakage"] = breakage_json(o, sim);
  }
  return j;
}
