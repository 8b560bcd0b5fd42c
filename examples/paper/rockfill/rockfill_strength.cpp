// SPDX-License-Identifier: BSL-1.0
#include "rockfill_strength.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

#include <riprap/measurement/leps_rockfill.hpp>

namespace rockfill {

namespace {

constexpr double degree = std::numbers::pi / 180;

double angle(const Sample& s) { return s.strength.friction_angle / degree; }
double normal_stress(const Sample& s) { return 1e-6 * s.strength.normal_stress; }

// phi [degrees] against sigma_n [MPa] of a law between two stresses [Pa].
template <class Law>
std::vector<riprap::Vec2> angles(const Law& law, double from, double to) {
  constexpr int steps = 40;
  std::vector<riprap::Vec2> points;
  for (int k = 0; k <= steps; ++k) {
    const double stress = k == steps ? to : from * std::pow(to / from, k / double{steps});
    points.push_back({1e-6 * stress, law.friction_angle(stress) / degree});
  }
  return points;
}

struct Range {
  double low = 0;   // [Pa]
  double high = 0;  // [Pa]
};

Range stress_range(const std::vector<Group>& groups) {
  Range range{groups.front().samples.front().strength.normal_stress, 0};
  for (const Group& g : groups)
    for (const Sample& s : g.samples) {
      range.low = std::min(range.low, s.strength.normal_stress);
      range.high = std::max(range.high, s.strength.normal_stress);
    }
  return range;
}

// Solid where the tests reached, dashed beyond.
void add_leps(riprap::Chart& chart, const Range& range) {
  // No run comes near the lower end of the tests, 1 psi.
  const double end = riprap::LepsRockfill::highest_stress;
  const auto add = [&](const std::string& name, const riprap::LogarithmicEnvelope& line,
                       const std::string& colour) {
    if (range.low < end)
      chart.series.push_back({name, angles(line, range.low, std::min(range.high, end)), colour});
    if (range.high > end)
      chart.series.push_back({range.low < end ? "" : name,
                              angles(line, std::max(range.low, end), range.high), colour, true});
  };
  add("Leps, high", riprap::LepsRockfill::high(), "#aaaaaa");
  add("Leps, average", riprap::LepsRockfill::average(), "#555555");
  add("Leps, low", riprap::LepsRockfill::low(), "#aaaaaa");
}

}  // namespace

std::string fixed(double value, int decimals) {
  if (!std::isfinite(value)) return "-";
  char buffer[400];
  const auto end =
      std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, decimals).ptr;
  return {buffer, end};
}

std::string with_deviation(const Statistic& value, int decimals) {
  if (!std::isfinite(value.mean) || value.deviation == 0) return fixed(value.mean, decimals);
  return fixed(value.mean, decimals) + " ± " + fixed(value.deviation, decimals);
}

Style style_of(const std::string& mode) {
  if (mode == "nb") return {"NB", "#1f6fb4", riprap::Mark::square};
  if (mode == "wb") return {"WB", "#d9661f", riprap::Mark::circle};
  return {mode, "#8250a0", riprap::Mark::triangle};
}

std::vector<Envelopes> envelopes(const std::vector<Group>& groups) {
  std::vector<Envelopes> out;
  for (std::size_t first = 0; first < groups.size();) {
    std::size_t end = first;
    std::vector<riprap::SecantStrength> tests;
    for (; end < groups.size() && groups[end].mode == groups[first].mode; ++end)
      for (const Sample& s : groups[end].samples) tests.push_back(s.strength);
    if (end - first >= 3)
      out.push_back(
          {groups[first].mode, riprap::fit_power_law(tests), riprap::fit_logarithmic_law(tests)});
    first = end;
  }
  return out;
}

std::vector<RoughnessBound> roughness_bounds(const Rock& rock) {
  const auto bound = [&rock](double roughness, double share) -> RoughnessBound {
    const double strength = share * rock.compressive_strength;
    return {"B-K " + fixed(roughness, 0) + ", " + fixed(1e-6 * strength, 0) + " MPa",
            {roughness, strength, rock.basic_friction_angle}};
  };
  return {bound(5, 0.2), bound(10, 0.5)};
}

riprap::Chart strength_chart(const std::vector<Group>& groups, const Rock& rock) {
  riprap::Chart chart{"Secant friction angle at the peak",
                      "normal stress [MPa]",
                      "phi [degrees]",
                      {},
                      riprap::AxisScale::logarithmic};
  const Range range = stress_range(groups);
  add_leps(chart, range);
  constexpr auto green = "#2e8b57";
  for (const RoughnessBound& b : roughness_bounds(rock))
    if (range.low < b.law.equivalent_strength)
      chart.series.push_back(
          {b.name,
           angles(b.law, range.low, std::min(range.high, 0.999 * b.law.equivalent_strength)), green,
           chart.series.back().colour == green});
  for (const Envelopes& e : envelopes(groups)) {
    const Style style = style_of(e.mode);
    chart.series.push_back(
        {style.name + ", fitted", angles(e.power, range.low, range.high), style.colour});
  }
  for (std::size_t first = 0; first < groups.size();) {
    const Style style = style_of(groups[first].mode);
    riprap::Series points{style.name, {}, style.colour, false, style.mark, false, {}};
    const std::string mode = groups[first].mode;
    for (; first < groups.size() && groups[first].mode == mode; ++first) {
      const Statistic phi = groups[first].statistic(angle);
      points.points.push_back({groups[first].statistic(normal_stress).mean, phi.mean});
      points.y_errors.push_back(phi.deviation);
    }
    chart.series.push_back(points);
  }
  return chart;
}

Table envelope_table(const std::vector<Group>& groups) {
  Table table{"Strength envelopes: tau/p_a = A (sigma_n/p_a)^b and "
              "phi = phi_0 - delta_phi log10(sigma_n/p_a), p_a = 101.325 kPa",
              {"mode", "A [-]", "b [-]", "scatter of tau [%]", "phi_0 [deg]", "delta_phi [deg]",
               "scatter of phi [deg]"},
              {}};
  for (const Envelopes& e : envelopes(groups))
    table.rows.push_back({style_of(e.mode).name, fixed(e.power.coefficient, 3),
                          fixed(e.power.exponent, 3), fixed(100 * e.power.scatter, 1),
                          fixed(e.logarithmic.angle_at_reference / degree, 1),
                          fixed(e.logarithmic.fall_per_decade / degree, 1),
                          fixed(e.logarithmic.scatter / degree, 1)});
  return table;
}

Table published_table(const std::vector<Group>& groups, const Rock& rock) {
  Table table{"Secant friction angle beside published ones [deg]",
              {"mode", "confining pressure [MPa]", "normal stress [MPa]", "phi here",
               "Leps (1970), low", "average", "high"},
              {}};
  const std::vector<RoughnessBound> bounds = roughness_bounds(rock);
  for (const RoughnessBound& b : bounds) table.head.push_back(b.name);
  for (const Group& g : groups) {
    const double stress = 1e6 * g.statistic(normal_stress).mean;
    std::vector<std::string> row{style_of(g.mode).name, fixed(1e-6 * g.pressure, 1),
                                 fixed(1e-6 * stress, 2), with_deviation(g.statistic(angle), 1)};
    // A star: no test went so far.
    const std::string star = riprap::LepsRockfill::covers(stress) ? "" : "*";
    for (const auto& line : {riprap::LepsRockfill::low(), riprap::LepsRockfill::average(),
                             riprap::LepsRockfill::high()})
      row.push_back(fixed(line.friction_angle(stress) / degree, 1) + star);
    for (const RoughnessBound& b : bounds)
      row.push_back(stress < b.law.equivalent_strength
                        ? fixed(b.law.friction_angle(stress) / degree, 1)
                        : "-");
    table.rows.push_back(row);
  }
  return table;
}

}  // namespace rockfill
