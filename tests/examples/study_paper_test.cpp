// SPDX-License-Identifier: BSL-1.0
// The table of the paper's study against the plan of examples/paper.
#include <study/runs.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>

#include <biaxial/options.hpp>
#include <biaxial/setup_json.hpp>
#include <paper/runs/study_design.hpp>

namespace {

using study::Json;
using study::Mode;
using study::RunPlan;
using study::Variation;

// The options that a file of parameters stands for.
Options options_of(const run_study::Run& run) {
  std::vector<std::string> arguments;
  for (const auto& [name, value] : run.parameters) arguments.push_back("--" + name + "=" + value);
  return options_from(arguments);
}

std::string row_name(const RunPlan& plan) {
  const std::string variation = to_text(plan.variation);
  return to_text(plan.mode) + (variation.empty() ? "" : "_") + variation;
}

// A preset is in the library: the plan takes it from there, the options name it.
std::string preset_of(const RunPlan& plan) {
  if (plan.variation == Variation::recommended_preset) return "recommended";
  return plan.variation == Variation::paper_preset ? "paper" : "model";
}

std::string line_fit_of(const RunPlan& plan, const Options& o) {
  if (plan.variation == Variation::mean_tension_line) return "mean-tension";
  if (plan.variation == Variation::failure_plane) return "plane";
  return preset_of(plan) == "model" ? "xy" : o.line_fit;
}

void check_model(const RunPlan& plan, const Options& o, const Json& wanted) {
  const Json& motion = wanted["motion"];
  CHECK(o.contact == "energy-conserving");
  CHECK(o.energy_conserving.normal_stiffness == motion["normal_stiffness_N_m"]);
  CHECK(o.energy_conserving.tangential_stiffness == motion["tangential_stiffness_N_m"]);
  CHECK(o.energy_conserving.friction == motion["friction"]);
  CHECK(o.damping.coefficient == motion["local_damping"]);
  CHECK(o.time_step.fraction == motion["time_step_fraction"]);
  CHECK(o.boundary == (plan.variation == Variation::periodic_cell ? "periodic" : "particles"));
  CHECK(o.support ==
        (plan.variation == Variation::two_pinned_contacts ? "pinned" : "inertia-relief"));
  if (plan.mode == Mode::nb) return;
  const Json& breakage = wanted["breakage"];
  CHECK(o.criterion == "hoek-brown");
  CHECK(o.hoek_brown.compressive_strength == breakage["compressive_strength_Pa"]);
  CHECK(o.hoek_brown.m_b == breakage["m_b"]);
  CHECK(o.hoek_brown.s == breakage["s"]);
  CHECK(o.hoek_brown.a_b == breakage["a_b"]);
  CHECK(o.mesher.triangles == breakage["mesh_triangles"]);
  CHECK(o.failed_elements.critical == breakage["ratf"]);
  CHECK(o.splitter.minimum_area == breakage["minimum_piece_area"]);
  CHECK(o.splitter.maximum_aspect == breakage["maximum_piece_aspect"]);
  CHECK(o.check_every == breakage["check_every"]);
}

}  // namespace

TEST_CASE("the table of the paper's study has the runs of examples/paper") {
  const run_study::Study table =
      run_study::study_of(run_study::read_table(RIPRAP_STUDY_TABLES "/paper.toml"));
  std::map<std::string, const run_study::Run*> of_key;
  const auto key = [](const std::string& row, double pressure, std::uint64_t seed) {
    return row + " " + riprap::to_text(pressure) + " " + std::to_string(seed);
  };
  for (const run_study::Run& run : table.runs)
    of_key[key(run.row, std::stod(run.parameters.at("pressure")), run.seed)] = &run;
  const std::vector<RunPlan> plans = study::all_runs(study::Options{});
  REQUIRE(of_key.size() == table.runs.size());
  CHECK(plans.size() == table.runs.size());
  for (const RunPlan& plan : plans) {
    CAPTURE(plan.name());
    const auto found = of_key.find(key(row_name(plan), plan.pressure, plan.seed));
    REQUIRE(found != of_key.end());
    const Options o = options_of(*found->second);
    const Json wanted = plan.parameters();
    CHECK(assembly_json(o.assembly) == wanted["assembly"]);
    CHECK(test_json(o.test) == wanted["test"]);
    CHECK(o.rock.young == wanted["rock"]["young_Pa"]);
    CHECK(o.rock.poisson == wanted["rock"]["poisson"]);
    CHECK(o.rock.density == wanted["rock"]["density_kg_m3"]);
    CHECK((o.breakage == "off") == (plan.mode == Mode::nb));
    CHECK(o.preset == preset_of(plan));
    CHECK(o.line_fit == line_fit_of(plan, o));
    if (o.preset == "model") check_model(plan, o, wanted);
  }
}

TEST_CASE("the tables that come with the example can be read") {
  for (const std::string name :
       {"paper", "contact_models", "sensitivity", "pressures", "size_effect"}) {
    CAPTURE(name);
    const auto table = run_study::study_of(
        run_study::read_table(std::string(RIPRAP_STUDY_TABLES "/") + name + ".toml"));
    std::set<std::string> names;
    for (const run_study::Run& run : table.runs) names.insert(run.folder);
    CHECK(names.size() == table.runs.size());
    // None needs a hash.
    CHECK(std::ranges::all_of(
        names, [](const std::string& n) { return n.rfind("_seed=") >= n.rfind('_'); }));
  }
}
