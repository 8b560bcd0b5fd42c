// SPDX-License-Identifier: BSL-1.0
// The options of contacts, motion, stress and breakage.

#include "option_groups.hpp"

namespace {

using command_line::OptionTable;

using Numbers = std::vector<command_line::Member<double>>;

void add_contact(OptionTable& table, Options& o) {
  table.begin_group("Contacts");
  table.add_choice("--contact", o.contact,
                   {"energy-conserving", "linear", "incremental", "area", "dashpot"},
                   "the energy-conserving spring on the moments of the overlap; or, on its chord, "
                   "linear springs, incremental springs, overlap area, springs with dashpot");
  table.add_number("--friction",
                   Numbers{{&o.energy_conserving.friction, "EnergyConservingSpring.friction"},
                           {&o.linear.friction, "LinearSpringCoulomb.friction"},
                           {&o.incremental.friction, "IncrementalSpring.friction"},
                           {&o.area.friction, "OverlapAreaSpring.friction"},
                           {&o.dashpot.friction, "SpringDashpot.friction"}},
                   "between particles [-]");
  table.add_number(
      "--normal-stiffness",
      Numbers{
          {&o.energy_conserving.normal_stiffness, "EnergyConservingSpring.normal_stiffness",
           "energy-conserving"},
          {&o.linear.normal_stiffness, "LinearSpringCoulomb.normal_stiffness", "linear"},
          {&o.incremental.normal_stiffness, "IncrementalSpring.normal_stiffness", "incremental"},
          {&o.dashpot.normal_stiffness, "SpringDashpot.normal_stiffness", "dashpot"}},
      "of a contact [N/m]", "--contact");
  table.add_number(
      "--tangential-stiffness",
      Numbers{{&o.energy_conserving.tangential_stiffness,
               "EnergyConservingSpring.tangential_stiffness"},
              {&o.linear.tangential_stiffness, "LinearSpringCoulomb.tangential_stiffness"},
              {&o.incremental.tangential_stiffness, "IncrementalSpring.tangential_stiffness"},
              {&o.area.tangential_stiffness, "OverlapAreaSpring.tangential_stiffness"},
              {&o.dashpot.tangential_stiffness, "SpringDashpot.tangential_stiffness"}},
      "of a contact [N/m]");
  table.add_number("--area-stiffness",
                   Numbers{{&o.area.area_stiffness, "OverlapAreaSpring.area_stiffness", "area"}},
                   "[N/m^3], for the default diameter, else in proportion to its inverse square",
                   "--contact");
  table.add_number("--largest-chord",
                   Numbers{{&o.area.largest_chord, "OverlapAreaSpring.largest_chord", "area"}},
                   "that sets the time step [m]; unless given, the mean diameter", "--contact");
  table.add_number("--damping-ratio",
                   Numbers{{&o.dashpot.damping_ratio, "SpringDashpot.damping_ratio", "dashpot"}},
                   "of a contact, over critical damping [-]", "--contact");
  table.add_flag("--dashpot-may-pull", o.dashpot.may_pull, "contacts may be in tension",
                 "--contact", "dashpot");
  table.add_number("--relative-skin", o.broad_phase.relative_skin, "UniformGrid.relative_skin",
                   "of the neighbour search, over the mean diameter [-]");
}

void add_motion(OptionTable& table, Options& o) {
  table.begin_group("Motion");
  table.add_choice("--boundary", o.boundary, {"particles", "platens", "periodic"},
                   "what encloses the sample: a ring of particles, four platens, a periodic cell");
  table.add_choice("--integrator", o.integrator, {"euler", "verlet"},
                   "symplectic Euler or velocity Verlet");
  table.add_number("--local-damping", o.damping.coefficient, "LocalDamping.coefficient", "[-]");
  table.add_number("--time-step-fraction",
                   Numbers{{&o.time_step.fraction, "MassFloor.fraction", "energy-conserving"},
                           {&o.time_step_of_others.fraction, "MassFloor.fraction", "linear"},
                           {&o.time_step_of_others.fraction, "MassFloor.fraction", "incremental"},
                           {&o.time_step_of_others.fraction, "MassFloor.fraction", "area"},
                           {&o.time_step_of_others.fraction, "MassFloor.fraction", "dashpot"}},
                   "time step over sqrt(m / k), k the peak stiffness [-]", "--contact");
}

void add_stress(OptionTable& table, Options& o) {
  table.begin_group("Stress in the particles");
  table.add_choice("--plane", o.plane, {"stress", "strain"}, "plane stress or plane strain");
  table.add_choice("--support", o.support, {"inertia-relief", "pinned"},
                   "of a particle in its stress analysis");
  table.add_number("--mesh-triangles", o.mesher.triangles, "UniformMesher.triangles",
                   "per particle [-]");
}

void add_criterion(OptionTable& table, Options& o) {
  const std::string criterion = "--criterion";
  table.add_choice(criterion, o.criterion,
                   {"hoek-brown", "mohr-coulomb", "griffith", "modified-griffith", "murrell",
                    "hobbs", "franklin"},
                   "failure of an element");
  table.add_number(
      "--compressive-strength",
      Numbers{{&o.hoek_brown.compressive_strength, "HoekBrown.compressive_strength", "hoek-brown"},
              {&o.hobbs.compressive_strength, "Hobbs.compressive_strength", "hobbs"},
              {&o.franklin.compressive_strength, "Franklin.compressive_strength", "franklin"}},
      "uniaxial [Pa]", criterion);
  table.add_number("--m-b", Numbers{{&o.hoek_brown.m_b, "HoekBrown.m_b", "hoek-brown"}}, "[-]",
                   criterion);
  table.add_number("--s", Numbers{{&o.hoek_brown.s, "HoekBrown.s", "hoek-brown"}},
                   "1 for intact rock [-]", criterion);
  table.add_number("--a-b", Numbers{{&o.hoek_brown.a_b, "HoekBrown.a_b", "hoek-brown"}},
                   "0.5 for intact rock [-]", criterion);
  table.add_choice("--hoek-brown-angle", o.hoek_brown_angle, {"equivalent", "tangent"},
                   "friction angle: of the equivalent Mohr-Coulomb fit, or the slope", criterion,
                   "hoek-brown");
  table.add_number("--cohesion",
                   Numbers{{&o.mohr_coulomb.cohesion, "MohrCoulomb.cohesion", "mohr-coulomb"}},
                   "[Pa]", criterion);
  table.add_number("--friction-angle",
                   Numbers{{&o.mohr_coulomb.angle, "MohrCoulomb.angle", "mohr-coulomb"}}, "[rad]",
                   criterion);
  table.add_number(
      "--tensile-strength",
      Numbers{{&o.mohr_coulomb.tension, "MohrCoulomb.tension", "mohr-coulomb"},
              {&o.griffith.tension, "Griffith.tension", "griffith"},
              {&o.modified_griffith.tension, "ModifiedGriffith.tension", "modified-griffith"},
              {&o.murrell.tension, "Murrell.tension", "murrell"},
              {&o.hobbs.tension, "Hobbs.tension", "hobbs"},
              {&o.franklin.tension, "Franklin.tension", "franklin"}},
      "[Pa]", criterion);
  table.add_number(
      "--crack-friction",
      Numbers{{&o.modified_griffith.friction, "ModifiedGriffith.friction", "modified-griffith"}},
      "between the faces of a closed crack [-]", criterion);
  table.add_number("--hobbs-factor", Numbers{{&o.hobbs.factor, "Hobbs.factor", "hobbs"}}, "[-]",
                   criterion);
  table.add_number("--strength-exponent",
                   Numbers{{&o.hobbs.exponent, "Hobbs.exponent", "hobbs"},
                           {&o.franklin.exponent, "Franklin.exponent", "franklin"}},
                   "of the strength curve [-]", criterion);
}

void add_scatter(OptionTable& table, Options& o) {
  const std::string scatter = "--strength-scatter";
  table.add_choice(scatter, o.strength_scatter, {"none", "weibull"},
                   "of the strengths of particles, drawn with the seed of the sample");
  table.add_number("--weibull-modulus",
                   Numbers{{&o.weibull.modulus, "WeibullStrength.modulus", "weibull"}},
                   "the higher, the more alike the particles [-]", scatter);
  table.add_number("--weibull-dimension",
                   Numbers{{&o.weibull.dimension, "WeibullStrength.dimension", "weibull"}},
                   "strength falls with size d as d^(-dimension / modulus): 3, flaws by volume, 2, "
                   "by area, 0, not at all [-]",
                   scatter);
  table.add_number("--strength-diameter",
                   Numbers{{&o.strength_diameter, "strength diameter", "weibull"}},
                   "at which the characteristic strength is that of the criterion or of the "
                   "trigger [m]",
                   scatter);
}

void add_breakage(OptionTable& table, Options& o) {
  table.begin_group("Breakage");
  table.add_choice("--breakage", o.breakage, {"on", "off"}, "may particles break?");
  add_criterion(table, o);
  const std::string trigger = "--trigger";
  table.add_choice(trigger, o.trigger,
                   {"failed-elements", "brazilian", "mean-stress", "hertz", "tsoungui"},
                   "breakage of a particle: by failed elements; or by its contact loads alone: the "
                   "two largest opposed forces, the mean stress in the criterion, the largest "
                   "force, the equivalent diametral compression");
  table.add_number(
      "--ratf",
      Numbers{{&o.failed_elements.critical, "FailedElementRatio.critical", "failed-elements"},
              {&o.weibull.critical, "WeibullStrength.critical", "failed-elements"}},
      "share of failed elements that breaks a particle [-]", trigger);
  table.add_number("--particle-strength",
                   Numbers{{&o.brazilian.strength, "BrazilianStrength.strength", "brazilian"},
                           {&o.hertzian.pressure, "HertzianStrength.pressure", "hertz"},
                           {&o.tsoungui.strength, "TsounguiStrength.strength", "tsoungui"}},
                   "Brazilian strength, or the largest pressure of a contact [Pa]", trigger);
  add_scatter(table, o);
  table.add_choice("--line-fit", o.line_fit,
                   {"xy", "x", "y", "xy-mean-stress", "mean-tension", "tls", "plane",
                    "loaded-diameter", "mean-stress", "mean-stress-plane"},
                   "crack line: the paper's choice, weighted X, Y, the choice by the mean stress, "
                   "across the mean tension, total least squares, failure plane; by the loads, of "
                   "which each trigger by the loads has its own: through the opposed forces, "
                   "across the tension of the mean stress, along its failure plane");
  table.add_number("--minimum-piece-area", o.splitter.minimum_area, "StraightCut.minimum_area",
                   "over the mean area of the intact particles [-]");
  table.add_number("--maximum-piece-aspect", o.splitter.maximum_aspect,
                   "StraightCut.maximum_aspect", "of a piece, diameter over least width [-]");
  table.add_number("--maximum-pieces", o.splitter.maximum_pieces, "StraightCut.maximum_pieces",
                   "of one intact particle; one more ends the run [-]");
  table.add_flag(
      "--dust", o.splitter.dust,
      "pieces below the least area are cut off and counted, no longer simulated; without "
      "it such cuts are refused");
  table.add_number("--check-every", o.check_every, "Model.check_every",
                   "steps between stress checks [-]");
}

}  // namespace

void add_model(OptionTable& table, Options& options) {
  table.begin_group("Model");
  table.add_choice("--preset", options.preset, {"model", "recommended", "paper"},
                   "Model{}, which options change; the recommended choices; the paper's to the "
                   "letter (docs/presets.md)");
  add_contact(table, options);
  add_motion(table, options);
  add_stress(table, options);
  add_breakage(table, options);
}
