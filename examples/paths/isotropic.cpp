// SPDX-License-Identifier: BSL-1.0
// Isotropic compression: the normal compression line, the yield stress against the strength of the
// rock, and the line of unloading.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <riprap/experiment/paths/isotropic_compression.hpp>
#include <riprap/experiment/preparation.hpp>
#include <riprap/measurement/compression_line.hpp>
#include <riprap/measurement/porosity.hpp>

#include "report.hpp"

namespace paths {

namespace {

using riprap::CompressionState;

// Contacts this stiff jam at nearly as much.
constexpr double first_pressure = 4e6;
// Stiffer than usual: springs are compressed, too.
constexpr double stiffness = 8e7;

struct Variant {
  const char* name;
  double strength;  // of the rock [Pa]; 0: nothing breaks
  const char* colour;
};
constexpr std::array<Variant, 4> variants{{{"60 MPa", 60e6, orange},
                                           {"120 MPa", 120e6, blue},
                                           {"240 MPa", 240e6, green},
                                           {"unbreakable", 0, grey}}};
constexpr auto unbreakable = variants.back().name;
constexpr double broken_share = 0.05;  // breakages over particles at the stress of crushing

// Steps of sqrt(2) up to the largest pressure, with a loop on the way, and down again.
std::vector<double> pressures(const Options& o) {
  const double turn = 16e6;
  const double largest = o.quick ? 23e6 : 46e6;
  std::vector<double> all;
  const auto climb = [&](double from, double to) {
    for (double p = from * std::sqrt(2.0); p < to; p *= std::sqrt(2.0)) all.push_back(p);
  };
  climb(first_pressure, 1.01 * turn);
  for (const double p : {8e6, 4e6, 8e6, turn}) all.push_back(p);
  climb(turn, largest);
  const double top = all.back();
  for (const double share : {0.5, 0.25, 0.125}) all.push_back(share * top);
  return all;
}

// At the ends of stages: those of first loading, and of the last unloading.
struct States {
  std::vector<CompressionState> loading{};
  std::vector<CompressionState> unloading{};
};

States states_of(const Run& run, const std::vector<double>& wanted) {
  const riprap::CurvePoint& start = run.points.front();
  States states{{{start.stress.mean(), riprap::void_ratio(start.porosity)}}};
  double largest = 0;
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const riprap::CurvePoint p = stage_end(run.points, first_stage + k);
    const CompressionState state{p.stress.mean(), riprap::void_ratio(p.porosity)};
    if (wanted[k] > largest * (1 + 1e-9)) {
      largest = wanted[k];
      states.loading.push_back(state);
      states.unloading = {state};
    } else if (k + 3 >= wanted.size()) {
      states.unloading.push_back(state);
    }
  }
  return states;
}

// What the void ratio has changed by beside that of the same sample if nothing breaks. The stresses
// of both agree to the tolerance of the stages, 1 %.
std::vector<CompressionState> crushing_part(const States& states, const States& intact) {
  std::vector<CompressionState> part;
  for (std::size_t k = 0; k < states.loading.size(); ++k)
    part.push_back(
        {states.loading[k].stress, states.loading[k].void_ratio - intact.loading[k].void_ratio});
  return part;
}

// The slope over the states from a stress on; not-a-number for fewer than three.
double slope_from(double stress, const std::vector<CompressionState>& states) {
  std::vector<CompressionState> part;
  for (const CompressionState& s : states)
    if (s.stress >= stress) part.push_back(s);
  return part.size() < 3 ? std::numeric_limits<double>::quiet_NaN()
                         : riprap::compression_line(part).slope;
}

// Mean stress at which so many breakages were counted since the start, from the ends of the stages
// of first loading, straight between them over its logarithm; not-a-number where they are not.
double crushing_stress(const Run& run, const std::vector<double>& wanted) {
  const double count = broken_share * run.plan.sample.particles;
  riprap::CurvePoint before = run.points.front();
  double largest = 0;
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    if (wanted[k] <= largest * (1 + 1e-9)) continue;
    largest = wanted[k];
    const riprap::CurvePoint p = stage_end(run.points, first_stage + k);
    if (static_cast<double>(p.breakages) >= count) {
      const auto low = static_cast<double>(before.breakages);
      const double share = (count - low) / (static_cast<double>(p.breakages) - low);
      return before.stress.mean() * std::pow(p.stress.mean() / before.stress.mean(), share);
    }
    before = p;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

// A value for each sample of a variant.
struct Lines {
  std::vector<double> apparent{};  // where two lines of the void ratio meet [Pa]
  std::vector<double> yield{};     // where two lines of the part of crushing meet [Pa]
  std::vector<double> crushing{};  // where the share of particles has broken [Pa]
  std::vector<double> lambda{};    // from there on
  std::vector<double> elastic{};   // of the unbreakable sample over the same stresses
  std::vector<double> kappa{};
  std::vector<double> hardin{};  // at the end
};

Lines lines_of(const std::vector<Run>& runs, const Variant& variant,
               const std::vector<double>& wanted) {
  Lines lines;
  const auto broken = runs_of(runs, variant.name);
  const auto intact = runs_of(runs, unbreakable);
  for (std::size_t k = 0; k < broken.size(); ++k) {
    const States states = states_of(*broken[k], wanted);
    lines.apparent.push_back(riprap::compression_yield(states.loading).stress);
    lines.kappa.push_back(riprap::compression_line(states.unloading).slope);
    lines.hardin.push_back(broken[k]->hardin.back());
    if (variant.strength == 0) continue;
    const States of_intact = states_of(*intact[k], wanted);
    const double crushing = crushing_stress(*broken[k], wanted);
    lines.yield.push_back(riprap::compression_yield(crushing_part(states, of_intact)).stress);
    lines.crushing.push_back(crushing);
    lines.lambda.push_back(slope_from(crushing, states.loading));
    lines.elastic.push_back(slope_from(crushing, of_intact.loading));
  }
  return lines;
}

void report(Findings& out, const Variant& variant, const Lines& lines, double top) {
  Json& j = out.numbers[variant.name];
  j = {{"kappa", spread(lines.kappa)},
       {"apparent_yield_stress_Pa", spread(lines.apparent)},
       {"hardin_b_r_at_the_end", spread(lines.hardin)}};
  std::string text = std::string(variant.name) + ": kappa " + spread_text(lines.kappa) +
                     ", two lines of e meet at " + spread_text(lines.apparent, 1e-6, "MPa");
  if (variant.strength > 0) {
    j["yield_stress_Pa"] = spread(lines.yield);
    j["stress_at_5_percent_breakages_Pa"] = spread(lines.crushing);
    j["lambda"] = spread(lines.lambda);
    j["lambda_of_the_unbreakable_sample"] = spread(lines.elastic);
    j["lambda_up_to_Pa"] = top;
    text += ", yield by crushing " + spread_text(lines.yield, 1e-6, "MPa") + ", 5 % breakages at " +
            spread_text(lines.crushing, 1e-6, "MPa") + ", lambda " + spread_text(lines.lambda) +
            " (unbreakable " + spread_text(lines.elastic) + ")";
  }
  out.lines.push_back(text);
}

void add_points(riprap::Chart& chart, const std::string& name, double strength,
                const std::vector<double>& stresses, const char* colour, riprap::Mark mark) {
  riprap::Series points{name, {}, colour, false, mark, false};
  for (const double stress : stresses)
    if (std::isfinite(stress)) points.points.push_back({in_mpa(strength), in_mpa(stress)});
  chart.series.push_back(points);
}

// Through the origin and the mean of some stresses.
riprap::Series proportional_to(double strength, const std::vector<double>& stresses) {
  const Json mean = spread(stresses)["mean"];
  riprap::Series line{"proportional", {}, grey, true};
  if (mean.is_null()) return line;
  for (const double f : {0.0, 2.0})
    line.points.push_back({in_mpa(f * strength), in_mpa(f * mean.get<double>())});
  return line;
}

}  // namespace

std::vector<PlannedRun> plan_isotropic(const Options& o) {
  std::vector<PlannedRun> runs;
  for (const Variant& v : variants) {
    PlannedRun run{.variant = v.name, .pressure = first_pressure};
    run.sample.breakage = v.strength > 0;
    if (v.strength > 0) run.sample.strength = v.strength;
    run.sample.stiffness = stiffness;
    run.stages = riprap::Preparation{}.stages(first_pressure);
    for (auto& stage :
         riprap::IsotropicCompression{.pressures = pressures(o)}.stages(first_pressure))
      run.stages.push_back(std::move(stage));
    add_runs(runs, o, run);
  }
  return runs;
}

Findings find_isotropic(const Options& o, const std::vector<Run>& runs) {
  const auto wanted = pressures(o);
  const Value pressure = [](const auto& p) { return in_mpa(p.stress.mean()); };
  const Value voids = [](const auto& p) { return riprap::void_ratio(p.porosity); };
  const Value breakages = [](const auto& p) { return static_cast<double>(p.breakages); };
  riprap::Chart compression =
      chart("Isotropic compression, first sample", "mean stress [MPa]", "void ratio e [-]");
  riprap::Chart crushing =
      chart("Void ratio lost by crushing", "mean stress [MPa]", "e unbreakable - e [-]");
  riprap::Chart yield =
      chart("Yield stress against strength", "strength of the rock [MPa]", "mean stress [MPa]");
  riprap::Chart count = chart("Breakages", "mean stress [MPa]", "count [-]");
  for (riprap::Chart* c : {&compression, &crushing, &count})
    c->x_scale = riprap::AxisScale::logarithmic;

  Findings out;
  const auto intact = runs_of(runs, unbreakable);
  riprap::Series proportional;
  for (const Variant& v : variants) {
    const Lines found = lines_of(runs, v, wanted);
    report(out, v, found, *std::max_element(wanted.begin(), wanted.end()));
    const auto all = runs_of(runs, v.name);
    compression.series.push_back(curve(*all.front(), pressure, voids, v.colour));
    compression.series.back().name = v.name;
    if (v.strength == 0) continue;
    add_curves(count, runs, v.name, v.name, v.colour, pressure, breakages);
    for (std::size_t k = 0; k < all.size(); ++k) {
      riprap::Series series{k == 0 ? v.name : "", {}, v.colour, false, riprap::Mark::circle};
      for (const CompressionState& s :
           crushing_part(states_of(*all[k], wanted), states_of(*intact[k], wanted)))
        series.points.push_back({in_mpa(s.stress), -s.void_ratio});
      crushing.series.push_back(series);
    }
    const bool first = yield.series.empty();
    add_points(yield, first ? "two lines, lost e" : "", v.strength, found.yield, blue,
               riprap::Mark::circle);
    add_points(yield, first ? "5 % breakages" : "", v.strength, found.crushing, orange,
               riprap::Mark::triangle);
    if (v.strength == 120e6) proportional = proportional_to(v.strength, found.crushing);
  }
  yield.series.push_back(proportional);
  out.charts = {compression, crushing, yield, count};
  return out;
}

}  // namespace paths
