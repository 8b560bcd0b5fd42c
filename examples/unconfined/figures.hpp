// SPDX-License-Identifier: BSL-1.0
#pragma once
// The charts: counterparts of Figs 4 and 5 of the paper, and what moves Rat.

#include <array>
#include <string>
#include <utility>
#include <vector>

#include <riprap/output/chart.hpp>

#include "study.hpp"

namespace unconfined {

inline constexpr std::array colours{"#1f6fb4", "#c0392b", "#15803d", "#a06cc0", "#b8860b"};
inline constexpr auto paper_colour = "#777";

inline std::vector<riprap::Vec2> scaled(const Sweep& s, double factor) {
  std::vector<riprap::Vec2> points = s.points;
  for (auto& p : points) p.x() *= factor;
  return points;
}

// The paper's range of RatF as two dashed lines over the width of the chart, and the floor of the
// axis: Rat from 0.
inline void add_paper_range(riprap::Chart& chart) {
  double low = chart.series.front().points.front().x();
  double high = low;
  for (const riprap::Series& s : chart.series)
    for (const auto& p : s.points) {
      low = std::min(low, p.x());
      high = std::max(high, p.x());
    }
  for (const double value : {paper_low, paper_high})
    chart.series.push_back({value == paper_low ? "0.32 and 0.39" : "",
                            {{low, value}, {high, value}},
                            paper_colour,
                            true});
  chart.series.push_back({"", {{low, 0}, {high, 0}}, "none"});
}

inline riprap::Chart chart_of(const Sweep& s, const std::string& title, double factor = 1,
                              const std::string& label = "") {
  riprap::Chart chart{title, label.empty() ? s.parameter : label, "Rat at failure [-]", {}};
  chart.series.push_back({"this rock", scaled(s, factor), colours[0]});
  add_paper_range(chart);
  return chart;
}

// Fig. 4.
inline riprap::Svg draw_poisson(const Study& s) {
  riprap::Chart chart{
      "Rat at failure against Poisson's ratio", "Poisson's ratio [-]", "Rat at failure [-]", {}};
  for (std::size_t i = 0; i < s.poisson.size(); ++i)
    chart.series.push_back({"m_b = " + riprap::to_text(s.poisson[i].m_b), s.poisson[i].sweep.points,
                            colours[i % colours.size()]});
  add_paper_range(chart);
  return riprap::chart_sheet({chart});
}

// Fig. 5, and the same against Young's modulus.
inline riprap::Svg draw_strength(const Study& s) {
  return riprap::chart_sheet(
      {chart_of(s.strength, "The strength does not matter at one m_b", 1e-6,
                "uniaxial compressive strength [MPa]"),
       chart_of(s.young, "Young's modulus does not matter", 1e-9, "Young's modulus [GPa]")});
}

inline riprap::Svg draw_others(const Study& s) {
  const std::array titles{"m_b", "Slenderness", "Friction of the platens",
                          "Load: a test stopped short of failure or beyond", "Mesh"};
  std::vector<riprap::Chart> charts;
  for (std::size_t i = 0; i < s.others.size(); ++i)
    charts.push_back(chart_of(s.others[i], titles[i]));
  return riprap::chart_sheet(charts);
}

}  // namespace unconfined
