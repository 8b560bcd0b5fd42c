// SPDX-License-Identifier: BSL-1.0
#pragma once
// What a biaxial test was set up with, for a summary.

#include <nlohmann/json.hpp>

#include <riprap/breakage/trigger/failed_area_ratio.hpp>
#include <riprap/breakage/trigger/failed_element_ratio.hpp>
#include <riprap/breakage/trigger/weibull_strength.hpp>
#include <riprap/experiment/biaxial_test.hpp>
#include <riprap/particle/random_placement.hpp>

inline nlohmann::ordered_json assembly_json(const riprap::RandomAssembly& a) {
  return {{"particles", a.count},
          {"seed", a.seed},
          {"mean_diameter_m", a.mean_diameter},
          {"thickness_m", a.thickness},
          {"diameters", {a.smallest_diameter, a.largest_diameter}},
          {"vertices", {a.shape.fewest_vertices, a.shape.most_vertices}},
          {"axis_ratios", {a.shape.smallest_axis_ratio, a.shape.largest_axis_ratio}},
          {"angle_jitter", a.shape.angle_jitter},
          {"solid_fraction", a.solid_fraction},
          {"dense_fraction", a.dense_fraction},
          {"boundary_spacing", a.boundary_spacing}};
}

inline nlohmann::ordered_json test_json(const riprap::BiaxialTest& t) {
  return {{"confining_pressure_Pa", t.confining_pressure},
          {"axial_strain", t.axial_strain},
          {"inertial_number", t.inertial_number},
          {"record_every", t.record_every},
          {"jam_pressure_Pa", t.jam_pressure},
          {"jam_kinetic_ratio", t.jam_kinetic_ratio},
          {"compaction_inertial_number", t.compaction_inertial_number},
          {"rest_unbalanced_force", t.rest_unbalanced_force},
          {"hydrostatic_tolerance", t.hydrostatic_tolerance},
          {"hydrostatic_unbalanced_force", t.hydrostatic_unbalanced_force},
          {"confinement_tolerance", t.confinement_tolerance},
          {"most_steps", t.most_steps}};
}

// RatF is of a measure.
inline const char* rat_measure(const riprap::FailedElementRatio&) { return "elements"; }
inline const char* rat_measure(const riprap::WeibullStrength&) { return "elements"; }
inline const char* rat_measure(const riprap::FailedAreaRatio&) { return "area"; }
