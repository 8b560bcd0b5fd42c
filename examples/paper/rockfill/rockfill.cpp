// SPDX-License-Identifier: BSL-1.0
#include "rockfill.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include <riprap/core/errors.hpp>

#include "rockfill_samples.hpp"
#include "rockfill_strength.hpp"

namespace rockfill {

namespace {

// A quantity against confining pressure [MPa]: one series a mode, means with their deviations.
template <class Quantity>
void add_against_pressure(riprap::Chart& chart, const std::vector<Group>& groups,
                          const std::string& suffix, bool dashed, Quantity quantity) {
  for (std::size_t i = 0; i < groups.size();) {
    const std::string mode = groups[i].mode;
    const Style style = style_of(mode);
    riprap::Series s{style.name + suffix, {}, style.colour, dashed, style.mark, true, {}};
    for (; i < groups.size() && groups[i].mode == mode; ++i) {
      const Statistic value = groups[i].statistic(quantity);
      if (!std::isfinite(value.mean)) continue;
      s.points.push_back({1e-6 * groups[i].pressure, value.mean});
      s.y_errors.push_back(value.deviation);
    }
    chart.series.push_back(s);
  }
}

riprap::Chart pressure_chart(const std::string& title, const std::string& y_label) {
  return {title, "confining pressure [MPa]", y_label, {}, riprap::AxisScale::logarithmic};
}

double breakage(const Sample& s) { return 100 * s.marsal; }
double stiffness(const Sample& s) { return 1e-6 * s.e_50.modulus; }
double strain_at_half(const Sample& s) { return 100 * s.e_50.axial_strain; }
double porosity_before(const Sample& s) { return s.initial_porosity; }
double porosity_after(const Sample& s) { return s.final_porosity; }

std::vector<riprap::Vec2> drawn(const std::vector<riprap::Grading>& curves) {
  std::vector<riprap::Vec2> points;
  for (const riprap::GradingPoint& p : mean_grading(curves))
    points.push_back({1e3 * p.size, 100 * p.passing});
  return points;
}

// Of the runs with breakage: all samples before, and those of each pressure after.
riprap::Chart grading_chart(const std::vector<Group>& groups) {
  riprap::Chart chart{"Gradings with breakage",
                      "size [mm]",
                      "finer by mass [%]",
                      {},
                      riprap::AxisScale::logarithmic};
  const std::vector<std::string> colours{"#9ecae1", "#6baed6", "#3182bd",
                                         "#fd8d3c", "#e6550d", "#a63603"};
  std::vector<riprap::Grading> before;
  for (const Group& g : groups) {
    if (g.mode != "wb") continue;
    std::vector<riprap::Grading> after;
    for (const Sample& s : g.samples) {
      before.push_back(s.before);
      after.push_back(s.after);
    }
    chart.series.push_back({"after, " + riprap::to_text(1e-6 * g.pressure) + " MPa", drawn(after),
                            colours[chart.series.size() % colours.size()]});
  }
  chart.series.insert(chart.series.begin(), {"before", drawn(before), "#222222", true});
  return chart;
}

Table sample_table(const std::vector<Group>& groups) {
  Table table{"Samples by mode and confining pressure: mean ± standard deviation",
              {"mode", "confining pressure [MPa]", "samples", "phi [deg]", "B_g (Marsal) [%]",
               "porosity before shear", "after", "E_50 [MPa]", "strain at E_50 [%]"},
              {}};
  for (const Group& g : groups) {
    const auto phi = [](const Sample& s) {
      return s.strength.friction_angle * 180 / std::numbers::pi;
    };
    table.rows.push_back(
        {style_of(g.mode).name, fixed(1e-6 * g.pressure, 1), std::to_string(g.samples.size()),
         with_deviation(g.statistic(phi), 1), with_deviation(g.statistic(breakage), 1),
         with_deviation(g.statistic(porosity_before), 3),
         with_deviation(g.statistic(porosity_after), 3), with_deviation(g.statistic(stiffness), 0),
         with_deviation(g.statistic(strain_at_half), 2)});
  }
  return table;
}

std::vector<std::string> notes(const Rock& rock) {
  return {
      "phi is the secant angle of the peak, without cohesion; the normal stress is that of the "
      "plane on which it acts, sigma_n = sigma_3 (1 + sin phi). The peak is the largest mean over "
      "2 % of axial strain.",
      "Leps (1970): straight lines of phi over log10 sigma_n, here at second hand through a table "
      "that practice uses, right to about 1 degree. His tests end at 500 psi, 3.4 MPa: a star or a "
      "dashed line of Leps is extrapolation. They are triaxial tests; a plane strain test of the "
      "same rock gives a larger angle, commonly by some degrees.",
      "Barton and Kjaernsli (1981), B-K with R and S: phi = R log10(S/sigma_n) + phi_b, phi_b = " +
          fixed(rock.basic_friction_angle * 180 / std::numbers::pi, 1) +
          " degrees, the friction of the contacts here. R from 5 to 10 degrees and S from 0.2 to "
          "0.5 of the rock's compressive strength are our choice of two ends of what their charts "
          "could give for angular stones; the samples did not determine them.",
      "E_50 is (sigma_1 - sigma_3) over axial strain where half the largest deviator is first "
      "reached, both from the start of shear. In plane strain under constant sigma_3 an elastic "
      "material would give E/(1 - nu^2).",
      "No piece is smaller than the rule for slivers allows, 8 % of the mean area or 0.28 of the "
      "mean diameter: fines are missing. Marsal's B_g, which sums what has left the sieves, feels "
      "it little; Hardin's B_r and Einav's, which measure the way to a grading with dust, cannot "
      "come near to what laboratories find."};
}

}  // namespace

Findings findings(const std::vector<nlohmann::ordered_json>& runs, const Rock& rock) {
  riprap::require(!runs.empty(), "number of runs", 0, "must be 1 or more");
  const std::vector<Group> groups = grouped(runs);
  riprap::Chart crushed = pressure_chart("Breakage", "Marsal's B_g [%]");
  add_against_pressure(crushed, groups, "", false, breakage);
  riprap::Chart pores = pressure_chart("Porosity", "porosity [-]");
  add_against_pressure(pores, groups, ", before", true, porosity_before);
  add_against_pressure(pores, groups, ", after", false, porosity_after);
  riprap::Chart stiff = pressure_chart("Secant modulus", "E_50 [MPa]");
  add_against_pressure(stiff, groups, "", false, stiffness);

  Findings out;
  out.charts = {strength_chart(groups, rock), std::move(crushed)};
  for (const Group& g : groups)
    if (g.mode == "wb") {
      out.charts.push_back(grading_chart(groups));
      break;
    }
  out.charts.push_back(std::move(pores));
  out.charts.push_back(std::move(stiff));
  out.tables = {sample_table(groups), envelope_table(groups), published_table(groups, rock)};
  out.notes = notes(rock);
  return out;
}

}  // namespace rockfill
