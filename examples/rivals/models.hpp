// SPDX-License-Identifier: BSL-1.0
#pragma once
// The models of breakage that are compared, each in a source of its own.

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>

#include <riprap/particle/assembly.hpp>

namespace rivals {

// Keeps the order in which things are written.
using Json = nlohmann::ordered_json;

// What a run is made of, but for its model.
struct Case {
  riprap::Assembly sample{};  // compacted, at rest
  double pressure = 2e6;      // confining [Pa]
  double strain = 0.1;        // axial, at the end of shear
  double strength = 12e6;     // Brazilian, of a disc of the mean diameter [Pa]
  double diameter = 0.016;    // mean, of the circle of equal area [m]
  unsigned cells = 12;        // of a bonded particle
  std::uint64_t seed = 1;     // of the cells
};

struct RivalModel {
  const char* name;   // in files
  const char* title;  // in charts
  const char* colour;
  Json (*run)(const Case&);
};

Json run_unbreakable(const Case&);
Json run_elements(const Case&);
Json run_opposed_forces(const Case&);
Json run_all_forces(const Case&);
Json run_largest_force(const Case&);
Json run_mean_stress(const Case&);
Json run_bonded(const Case&);

inline constexpr std::array<RivalModel, 7> all_models{{
    {"unbreakable", "none", "#999999", run_unbreakable},
    {"elements", "finite elements", "#1f6fb4", run_elements},
    {"opposed_forces", "opposed forces", "#15803d", run_opposed_forces},
    {"all_forces", "all forces", "#c0392b", run_all_forces},
    {"largest_force", "largest force", "#a06cc0", run_largest_force},
    {"mean_stress", "mean stress", "#b8860b", run_mean_stress},
    {"bonded", "bonded cells", "#000000", run_bonded},
}};

}  // namespace rivals
