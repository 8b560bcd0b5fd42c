// SPDX-License-Identifier: BSL-1.0
// Drained biaxial compression with loops of unloading and reloading.

#include <riprap/experiment/loading_stage.hpp>
#include <riprap/experiment/preparation.hpp>
#include <riprap/measurement/secant_modulus.hpp>

#include "report.hpp"

namespace paths {

namespace {

constexpr double pressure = 2e6;
constexpr double rest = 0.1e6;  // stress difference at which unloading ends [Pa]
constexpr auto variant = "biaxial with loops";

// Axial strains at which the sample is unloaded, and the last one.
std::vector<double> turns(const Options& o) {
  if (o.quick) return {0.005, 0.01};
  return {0.005, 0.01, 0.02, 0.04, 0.06};
}

riprap::LoadingStage<> stage(const std::string& name, bool loads, const riprap::EndCondition& end) {
  const riprap::LoadingRate rate{.inertial_number = 5e-4};
  return {.name = name,
          .axis_1 =
              riprap::ControlledStress{.stress = pressure, .control = {.expected_rate = rate}},
          .axis_2 = riprap::EngineeringRate{.rate_of_strain = loads ? rate : -rate},
          .end = end,
          .record_every = 0.0001};
}

riprap::Vec2 place(const riprap::CurvePoint& p) { return {p.axial_strain, difference(p)}; }

// Moduli of one sample.
struct Moduli {
  double first = 0;  // secant of first loading at 0.1 % [Pa]
  double half = 0;   // E_50 of first loading up to the first turn
  std::vector<double> loops{};
  std::vector<double> areas{};  // of the loops [J/m^3]
};

Moduli moduli_of(const Run& run, std::size_t loops) {
  Moduli m;
  std::vector<riprap::Vec2> first;
  for (const auto& p : stage_points(run.points, first_stage)) first.push_back(place(p));
  m.first = riprap::secant_modulus_at_strain(first, 0.001).modulus;
  m.half = riprap::secant_modulus_at_share(first).modulus;
  for (std::size_t k = 0; k < loops; ++k) {
    const Points down = stage_points(run.points, first_stage + 1 + 2 * k);
    const Points up = stage_points(run.points, first_stage + 2 + 2 * k);
    m.loops.push_back(secant(place(down.back()), place(down.front())));
    std::vector<riprap::Vec2> loop;
    for (const auto& p : down) loop.push_back(place(p));
    for (const auto& p : up) {
      if (p.axial_strain > down.front().axial_strain) break;
      loop.push_back(place(p));
    }
    m.areas.push_back(loop_area(loop));
  }
  return m;
}

}  // namespace

std::vector<PlannedRun> plan_unloading(const Options& o) {
  PlannedRun run{.variant = variant, .pressure = pressure};
  run.stages = riprap::Preparation{}.stages(pressure);
  const auto ends = turns(o);
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const std::string number = std::to_string(k + 1);
    run.stages.push_back(
        stage("loading " + number, true, riprap::StrainReached{.strain = ends[k]}));
    if (k + 1 == ends.size()) break;
    run.stages.push_back(
        stage("unloading " + number, false,
              riprap::StressReached{.stress = rest, .of = riprap::StressOf::difference}));
  }
  std::vector<PlannedRun> runs;
  add_runs(runs, o, run);
  return runs;
}

Findings find_unloading(const Options& o, const std::vector<Run>& runs) {
  const std::size_t loops = turns(o).size() - 1;
  std::vector<double> first;
  std::vector<double> half;
  std::vector<std::vector<double>> of_loops(loops);
  std::vector<std::vector<double>> areas(loops);
  for (const Run* run : runs_of(runs, variant)) {
    const Moduli m = moduli_of(*run, loops);
    first.push_back(m.first);
    half.push_back(m.half);
    for (std::size_t k = 0; k < loops; ++k) {
      of_loops[k].push_back(m.loops[k]);
      areas[k].push_back(m.areas[k]);
    }
  }

  Findings out;
  riprap::Chart moduli = chart("Moduli", "axial strain at the turn [%]", "secant modulus [MPa]");
  moduli.series.push_back({"unloading", {}, orange, false, riprap::Mark::circle, false});
  Json all = Json::array();
  for (std::size_t k = 0; k < loops; ++k) {
    all.push_back({{"axial_strain", turns(o)[k]},
                   {"unloading_modulus_Pa", spread(of_loops[k])},
                   {"loop_area_J_m3", spread(areas[k])}});
    out.lines.push_back("unloaded at " + riprap::to_text(in_per_cent(turns(o)[k])) +
                        " % strain: modulus " + spread_text(of_loops[k], 1e-6) + " MPa, loop " +
                        spread_text(areas[k], 1e-3) + " kJ/m^3");
    for (const double modulus : of_loops[k])
      moduli.series.back().points.push_back({in_per_cent(turns(o)[k]), in_mpa(modulus)});
  }
  for (const auto& [name, values, colour] :
       {std::tuple{"first, 0.1 %", &first, blue}, std::tuple{"first, E_50", &half, grey}}) {
    const double mean = spread(*values)["mean"];
    moduli.series.push_back({name,
                             {{0, in_mpa(mean)}, {in_per_cent(turns(o)[loops - 1]), in_mpa(mean)}},
                             colour,
                             true});
  }
  out.numbers = {{"first_loading_secant_at_0.1_percent_Pa", spread(first)},
                 {"first_loading_E_50_up_to_the_first_turn_Pa", spread(half)},
                 {"loops", all}};
  out.lines.insert(out.lines.begin(), "first loading: secant at 0.1 % " +
                                          spread_text(first, 1e-6, "MPa") + ", E_50 " +
                                          spread_text(half, 1e-6, "MPa"));

  const Value strain = [](const auto& p) { return in_per_cent(p.axial_strain); };
  riprap::Chart stress =
      chart("Drained biaxial compression, 2 MPa", "axial strain [%]", "stress difference [MPa]");
  riprap::Chart volume =
      chart("Volume", "axial strain [%]", "volumetric strain [%], contraction +");
  riprap::Chart broken = chart("Breakages", "axial strain [%]", "count [-]");
  bool is_first = true;
  for (const Run* run : runs_of(runs, variant)) {
    const char* const colour = is_first ? blue : "#b9cfe4";
    is_first = false;
    const auto add = [&](riprap::Chart& c, const Value& y) {
      c.series.insert(c.series.begin(), curve(*run, strain, y, colour));
    };
    add(stress, [](const auto& p) { return in_mpa(difference(p)); });
    add(volume, [](const auto& p) { return in_per_cent(p.volumetric_strain); });
    add(broken, [](const auto& p) { return static_cast<double>(p.breakages); });
  }
  out.charts = {stress, volume, moduli, broken};
  return out;
}

}  // namespace paths
