// SPDX-License-Identifier: BSL-1.0
#pragma once
// The tests: which runs each of them makes, and what is found in them.

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include <riprap/output/chart.hpp>

#include "options.hpp"
#include "run_path.hpp"

namespace paths {

// Keeps the order in which things are written.
using Json = nlohmann::ordered_json;

struct Findings {
  std::vector<riprap::Chart> charts{};
  Json numbers = Json::object();
  std::vector<std::string> lines{};  // to print
};

struct TestCase {
  const char* name;
  const char* what;
  std::vector<PlannedRun> (*plan)(const Options&);
  Findings (*find)(const Options&, const std::vector<Run>&);  // the runs as planned
};

std::vector<PlannedRun> plan_isotropic(const Options&);
Findings find_isotropic(const Options&, const std::vector<Run>&);
std::vector<PlannedRun> plan_oedometer(const Options&);
Findings find_oedometer(const Options&, const std::vector<Run>&);
std::vector<PlannedRun> plan_unloading(const Options&);
Findings find_unloading(const Options&, const std::vector<Run>&);
std::vector<PlannedRun> plan_cyclic(const Options&);
Findings find_cyclic(const Options&, const std::vector<Run>&);
std::vector<PlannedRun> plan_mean_stress(const Options&);
Findings find_mean_stress(const Options&, const std::vector<Run>&);
std::vector<PlannedRun> plan_undrained(const Options&);
Findings find_undrained(const Options&, const std::vector<Run>&);
// The path of the file that the options name, or of the copy of it in the folder of a test that
// goes on; throws InvalidInput for a path that cannot be run.
std::vector<PlannedRun> plan_from_file(const Options&);
Findings find_from_file(const Options&, const std::vector<Run>&);

inline constexpr std::array<TestCase, 6> test_cases{{
    {"isotropic", "isotropic compression: lambda, kappa, yield stress against particle strength",
     plan_isotropic, find_isotropic},
    {"oedometer", "compression without lateral strain: K0, breakage", plan_oedometer,
     find_oedometer},
    {"unloading", "biaxial compression with loops of unloading and reloading: moduli",
     plan_unloading, find_unloading},
    {"cyclic", "cycles between two axial strains: loops, volume, energy", plan_cyclic, find_cyclic},
    {"mean_stress", "shear at constant mean stress: stress ratio, volume", plan_mean_stress,
     find_mean_stress},
    {"undrained", "shear at constant volume of a dense and a loose sample: effective stress path",
     plan_undrained, find_undrained},
}};

}  // namespace paths
