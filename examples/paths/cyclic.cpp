// SPDX-License-Identifier: BSL-1.0
// Cycles between two axial strains at constant lateral stress.

#include <riprap/experiment/paths/cyclic_shear.hpp>
#include <riprap/experiment/preparation.hpp>

#include "report.hpp"

namespace paths {

namespace {

constexpr double pressure = 4e6;
constexpr double amplitude = 0.003;
constexpr double strength = 60e6;  // a weak rock, of which some particles break
constexpr auto variant = "cyclic";

int cycles(const Options& o) { return o.quick ? 3 : 20; }

// What a cycle from one lower limit to the next leaves; the first one starts in the middle and does
// not count. Energies per volume at zero strain [J/m^3].
struct Cycle {
  double volumetric_strain = 0;  // at its end
  double breakages = 0;          // in the cycle
  double area = 0;               // of the loop
  double work = 0;               // of the stresses
  double boundary_work = 0;      // of the ledger
  double dissipated = 0;         // of the ledger: slip, damping, breakage, what the law leaves
  double slip = 0;
  double damping = 0;
  double broken = 0;  // what breakage took
};

Cycle cycle_of(const Run& run, int number) {
  const auto up = first_stage + 2 * static_cast<std::size_t>(number - 1);
  Points points = stage_points(run.points, up);
  const Points down = stage_points(run.points, up + 1);
  points.insert(points.end(), down.begin() + 1, down.end());
  std::vector<riprap::Vec2> loop;
  for (const auto& p : points) loop.push_back({p.axial_strain, difference(p)});
  const riprap::CurvePoint& from = points.front();
  const riprap::CurvePoint& to = points.back();
  const double volume = run.area * run.thickness;
  const auto change = [&](auto value) { return (value(to.energy) - value(from.energy)) / volume; };
  Cycle c;
  c.volumetric_strain = to.volumetric_strain;
  c.breakages = static_cast<double>(to.breakages - from.breakages);
  c.area = loop_area(loop);
  c.work = stress_work(points);
  c.boundary_work = change([](const auto& e) { return e.boundary_work; });
  c.dissipated = change(
      [](const auto& e) { return e.slip + e.dashpot + e.damping + e.breakage + e.law_residual; });
  c.slip = change([](const auto& e) { return e.slip; });
  c.damping = change([](const auto& e) { return e.damping; });
  c.broken = change([](const auto& e) { return e.breakage; });
  return c;
}

struct Quantity {
  const char* name;
  double Cycle::*value;
};
constexpr std::array<Quantity, 9> quantities{{{"volumetric_strain", &Cycle::volumetric_strain},
                                              {"breakages_in_the_cycle", &Cycle::breakages},
                                              {"loop_area_J_m3", &Cycle::area},
                                              {"stress_work_J_m3", &Cycle::work},
                                              {"boundary_work_J_m3", &Cycle::boundary_work},
                                              {"dissipated_J_m3", &Cycle::dissipated},
                                              {"slip_J_m3", &Cycle::slip},
                                              {"damping_J_m3", &Cycle::damping},
                                              {"breakage_J_m3", &Cycle::broken}}};

}  // namespace

std::vector<PlannedRun> plan_cyclic(const Options& o) {
  PlannedRun run{.variant = variant, .pressure = pressure};
  run.sample.strength = strength;
  run.stages = riprap::Preparation{}.stages(pressure);
  for (auto& stage : riprap::CyclicShear{.lower = -amplitude,
                     .upper = amplitude,
                     .cycles = cycles(o),
                     .pressure = pressure,
                     .inertial_number = 5e-4,
                     .record_every = 0.0001}
                         .stages())
    run.stages.push_back(std::move(stage));
  std::vector<PlannedRun> runs;
  add_runs(runs, o, run);
  return runs;
}

Findings find_cyclic(const Options& o, const std::vector<Run>& runs) {
  Findings out;
  const auto cases = runs_of(runs, variant);
  // By cycle, from the second.
  std::vector<std::vector<Cycle>> all;
  for (int number = 2; number <= cycles(o); ++number) {
    all.emplace_back();
    for (const Run* run : cases) all.back().push_back(cycle_of(*run, number));
  }
  const auto values = [](const std::vector<Cycle>& cycle, double Cycle::*value) {
    std::vector<double> numbers;
    for (const Cycle& c : cycle) numbers.push_back(c.*value);
    return numbers;
  };
  out.numbers["cycles"] = Json::array();
  for (std::size_t k = 0; k < all.size(); ++k) {
    Json cycle = {{"cycle", k + 2}};
    for (const Quantity& q : quantities) cycle[q.name] = spread(values(all[k], q.value));
    out.numbers["cycles"].push_back(cycle);
    if (k > 0 && k + 1 < all.size()) continue;
    out.lines.push_back("cycle " + std::to_string(k + 2) + ": loop " +
                        spread_text(values(all[k], &Cycle::area), 1e-3) + ", stress work " +
                        spread_text(values(all[k], &Cycle::work), 1e-3) + ", boundary work " +
                        spread_text(values(all[k], &Cycle::boundary_work), 1e-3) + ", dissipated " +
                        spread_text(values(all[k], &Cycle::dissipated), 1e-3) +
                        " kJ/m^3; breakages " + spread_text(values(all[k], &Cycle::breakages)) +
                        "; volumetric strain " +
                        spread_text(values(all[k], &Cycle::volumetric_strain), 100, "%"));
  }

  riprap::Chart loops =
      chart("Cycles of the first sample, 4 MPa", "axial strain [%]", "stress difference [MPa]");
  const Run& run = *cases.front();
  for (const auto& [number, colour] :
       {std::pair{cycles(o), orange}, std::pair{2, blue}, std::pair{1, grey}}) {
    riprap::Series series{"cycle " + std::to_string(number), {}, colour};
    for (std::size_t half : {0U, 1U})
      for (const auto& p :
           stage_points(run.points, first_stage + 2 * static_cast<std::size_t>(number - 1) + half))
        series.points.push_back({in_per_cent(p.axial_strain), in_mpa(difference(p))});
    loops.series.insert(loops.series.begin(), series);
  }
  const auto against_cycle = [&](riprap::Chart& c, const char* name, const char* colour,
                                 double factor, double Cycle::*value, bool mean) {
    const std::size_t lines = mean ? 1 : cases.size();
    for (std::size_t s = 0; s < lines; ++s) {
      riprap::Series series{s == 0 ? name : "", {}, colour};
      for (std::size_t k = 0; k < all.size(); ++k)
        series.points.push_back(
            {static_cast<double>(k + 2),
             factor * (mean ? double(spread(values(all[k], value))["mean"]) : all[k][s].*value)});
      c.series.push_back(series);
    }
  };
  riprap::Chart volume =
      chart("Volume at the end of a cycle", "cycle", "volumetric strain [%], contraction +");
  against_cycle(volume, "", blue, 100, &Cycle::volumetric_strain, false);
  riprap::Chart broken = chart("Breakages in a cycle", "cycle", "count [-]");
  against_cycle(broken, "", blue, 1, &Cycle::breakages, false);
  riprap::Chart energy =
      chart("Energy of a cycle, mean of the samples", "cycle", "energy [kJ/m^3]");
  against_cycle(energy, "area of the loop", blue, 1e-3, &Cycle::area, true);
  against_cycle(energy, "stress work", green, 1e-3, &Cycle::work, true);
  against_cycle(energy, "boundary work", purple, 1e-3, &Cycle::boundary_work, true);
  energy.series.back().dashed = true;
  against_cycle(energy, "dissipated", orange, 1e-3, &Cycle::dissipated, true);
  against_cycle(energy, "by slip", grey, 1e-3, &Cycle::slip, true);
  against_cycle(energy, "by damping", "#c0392b", 1e-3, &Cycle::damping, true);
  out.charts = {loops, volume, broken, energy};
  return out;
}

}  // namespace paths
