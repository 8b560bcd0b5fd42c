// SPDX-License-Identifier: BSL-1.0
#include "report.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <span>

#include <riprap/output/chart.hpp>

#include "closed_forms.hpp"
#include "spread.hpp"

namespace convergence {

namespace {

constexpr double usual_m_b = 25;

using Filter = std::function<bool(const MeasuredSet&, const Measurement&)>;

// A column of a table.
struct Group {
  std::string name;
  Filter in;
  std::size_t line = 0;  // of line_names
};

bool is_intact_stress(const MeasuredSet& set, const Measurement& m) {
  return !set.pieces && m.plane == Plane::stress;
}
bool is_usual(const MeasuredSet& set, const Measurement& m) {
  return is_intact_stress(set, m) && m.m_b == usual_m_b;
}

template <class Value>
std::vector<double> values_of(const std::vector<MeasuredSet>& sets, const Filter& in,
                              const MeshChoice& mesh, const Value& value) {
  std::vector<double> values;
  for (const MeasuredSet& set : sets)
    for (const Measurement& m : set.measurements)
      if (m.mesh == mesh.name && m.points == points_asked(mesh) && in(set, m))
        values.push_back(value(m));
  return values;
}

std::string row(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += " " + cell + " |";
  return line + "\n";
}
std::string head(const std::vector<std::string>& cells) {
  std::string rule = "|";
  for (std::size_t i = 0; i < cells.size(); ++i) rule += "---|";
  return row(cells) + rule + "\n";
}

std::vector<Group> groups_of_sets(const std::vector<MeasuredSet>& sets) {
  std::vector<Group> groups;
  for (const MeasuredSet& set : sets)
    groups.push_back({set.name, [name = set.name](const MeasuredSet& s, const Measurement& m) {
                        return s.name == name && m.plane == Plane::stress && m.m_b == usual_m_b;
                      }});
  groups.push_back({"all but pieces", is_usual});
  groups.push_back({"of these, below 2", [](const MeasuredSet& s, const Measurement& m) {
                      return is_usual(s, m) && m.reference_load < 2;
                    }});
  return groups;
}
std::vector<Group> groups_of_m_b() {
  std::vector<Group> groups;
  for (const double m_b : m_b_values)
    groups.push_back(
        {"m_b " + riprap::to_text(m_b), [m_b](const MeasuredSet& s, const Measurement& m) {
           return is_intact_stress(s, m) && m.m_b == m_b;
         }});
  return groups;
}
std::vector<Group> groups_of_planes() {
  std::vector<Group> groups;
  for (const Plane plane : {Plane::stress, Plane::strain})
    groups.push_back({plane == Plane::stress ? "plane stress" : "plane strain",
                      [plane](const MeasuredSet& s, const Measurement& m) {
                        return s.plane_strain && m.plane == plane && m.m_b == usual_m_b;
                      }});
  return groups;
}

// Meshes in rows, groups in columns. Rows without a number are left out.
template <class Cell>
std::string mesh_table(const std::vector<Group>& groups, const Cell& cell) {
  std::vector<std::string> titles{"mesh", "points"};
  for (const Group& group : groups) titles.push_back(group.name);
  std::string lines = head(titles);
  for (const MeshChoice& mesh : std::span(meshes).subspan(2)) {  // but reference and check
    std::vector<std::string> cells{mesh.name, std::to_string(points_asked(mesh))};
    bool any = false;
    for (const Group& group : groups) {
      cells.push_back(cell(group, mesh));
      any = any || cells.back() != "-";
    }
    if (any) lines += row(cells);
  }
  return lines;
}

std::string load_table(const std::vector<MeasuredSet>& sets, const std::vector<Group>& groups,
                       double (*error)(const Measurement&)) {
  return mesh_table(groups, [&](const Group& group, const MeshChoice& mesh) {
    return text(spread(values_of(sets, group.in, mesh, error)));
  });
}

std::string limit_table(const std::vector<MeasuredSet>& sets, std::vector<Group> groups) {
  groups.insert(groups.begin(), {"calibrated_limit", {}});
  return mesh_table(groups, [&](const Group& group, const MeshChoice& mesh) {
    if (!group.in) return text("%.3f", limit_of(mesh));
    return text("%.3f", quantile(values_of(sets, group.in, mesh,
                                           [](const Measurement& m) { return m.share; }),
                                 0.5));
  });
}

std::string line_table(const std::vector<MeasuredSet>& sets) {
  std::vector<Group> groups;
  for (std::size_t k = 0; k < line_names.size(); ++k)
    groups.push_back({line_names[k], is_usual, k});
  return mesh_table(groups, [&](const Group& group, const MeshChoice& mesh) {
    const Spread s = spread(values_of(
        sets, group.in, mesh, [&](const Measurement& m) { return angle_error(m, group.line); }));
    return s.count == 0 ? "-" : text("%.1f", s.median) + ", " + text("%.1f", s.ninth);
  });
}

std::string accepted_table(const std::vector<MeasuredSet>& sets) {
  std::vector<std::string> titles{"mesh"};
  titles.insert(titles.end(), line_names.begin(), line_names.end());
  std::string lines = head(titles);
  for (const MeshChoice& mesh : meshes) {
    if (std::string(mesh.name) != "reference" && points_asked(mesh) != 100) continue;
    std::vector<std::string> cells{std::string(mesh.name) + ", " +
                                   std::to_string(points_asked(mesh))};
    for (std::size_t k = 0; k < line_names.size(); ++k)
      cells.push_back(
          text("%.2f", spread(values_of(sets, is_usual, mesh, [&](const Measurement& m) {
                         return m.accepted[k] ? 1.0 : 0.0;
                       })).bias));
    lines += row(cells);
  }
  return lines;
}

std::string reference_table(const std::vector<MeasuredSet>& sets) {
  std::string lines = head({"six-node triangles", "beside", "particles", "load: bias, median, 90 %",
                            "MeanTensionLine: median, 90 % [degrees]"});
  for (const MeshChoice& mesh : {meshes[1], fine_mesh}) {
    const Spread load = spread(values_of(sets, is_usual, mesh, load_error));
    const Spread angle = spread(
        values_of(sets, is_usual, mesh, [](const Measurement& m) { return angle_error(m, 2); }));
    lines += row({std::to_string(mesh.triangles), std::to_string(meshes[0].triangles),
                  std::to_string(load.count),
                  text("%+.3f", load.bias) + ", " + text("%.3f", load.median) + ", " +
                      text("%.3f", load.ninth),
                  text("%.2f", angle.median) + ", " + text("%.2f", angle.ninth)});
  }
  return lines;
}

std::string count_table(const std::vector<MeasuredSet>& sets) {
  std::string lines = head({"particles of", "measured",
                            "critical load over that of the test, "
                            "m_b 25: 10 %, median"});
  for (const MeasuredSet& set : sets) {
    const auto loads = values_of(
        {set},
        [](const MeasuredSet&, const Measurement& m) {
          return m.plane == Plane::stress && m.m_b == usual_m_b;
        },
        meshes[0], [](const Measurement& m) { return m.load; });
    lines += row({set.name, std::to_string(loads.size()),
                  text("%.2g", quantile(loads, 0.1)) + ", " + text("%.2g", quantile(loads, 0.5))});
  }
  return lines;
}

// `value` of each mesh of one name against its points.
template <class Value>
riprap::Series series(const std::string& mesh, const std::string& name, const char* colour,
                      const Value& value) {
  riprap::Series s{.name = name, .points = {}, .colour = colour, .mark = riprap::Mark::circle};
  for (const MeshChoice& choice : meshes) {
    if (choice.name != mesh) continue;
    const double y = value(choice);
    if (!std::isnan(y)) s.points.emplace_back(points_asked(choice), y);
  }
  return s;
}

}  // namespace

std::string tables(const std::vector<MeasuredSet>& sets) {
  std::string all;
  const auto add = [&](const char* title, const std::string& table) {
    all += std::string("#### ") + title + "\n\n" + table + "\n";
  };
  add("Particles", count_table(sets));
  add("Critical load", load_table(sets, groups_of_sets(sets), load_error));
  add("Critical load by the calibrated limit",
      load_table(sets, groups_of_sets(sets), calibrated_load_error));
  add("Limit at which the median load is that of the reference",
      limit_table(sets, groups_of_sets(sets)));
  add("Critical load of other rocks", load_table(sets, groups_of_m_b(), load_error));
  add("Critical load of other rocks by the calibrated limit",
      load_table(sets, groups_of_m_b(), calibrated_load_error));
  add("Limit of other rocks", limit_table(sets, groups_of_m_b()));
  add("Plane strain", load_table(sets, groups_of_planes(), load_error));
  add("Crack line", line_table(sets));
  add("Cuts that StraightCut accepts", accepted_table(sets));
  add("Error of the reference", reference_table(sets));
  add("Closed forms", closed_form_table());
  return all;
}

std::string closed_form_table() {
  std::string lines = head({"mesh", "points", "disc: load over closed form", "disc: share failed",
                            "bar: load over closed form", "bar: share failed"});
  const riprap::HoekBrown criterion;
  for (const MeshChoice& mesh : meshes) {
    if (mesh.graded) continue;  // the forces on the bar are spread over its ends
    std::vector<std::string> cells{mesh.name, ""};
    for (const KnownStrength& known : {disc_between_forces(), bent_bar()}) {
      const Field field =
          stress_field(known.body.particles.front(), known.body.thickness, mesh, Plane::stress);
      const std::vector<double> areas = field.areas();
      cells[1] += (cells[1].empty() ? "" : ", ") + std::to_string(areas.size());
      cells.push_back(
          text("%.3f", critical_load(criterion, field.stress, areas, limit) / known.load));
      cells.push_back(text("%.3f", failed_share(criterion, field.stress, areas, known.load)));
    }
    lines += row(cells);
  }
  return lines;
}

riprap::Svg charts(const std::vector<MeasuredSet>& sets) {
  riprap::Chart load{"Critical load: error in one of ten particles",
                     "sampling points [-]",
                     "90 % quantile of |ln (load / reference)| [-]",
                     {},
                     riprap::AxisScale::logarithmic,
                     riprap::AxisScale::logarithmic};
  const auto add_load = [&](const std::string& mesh, const std::string& name, const char* colour,
                            double (*error)(const Measurement&), bool dashed) {
    load.series.push_back(series(mesh, name, colour, [&](const MeshChoice& choice) {
      return spread(values_of(sets, is_usual, choice, error)).ninth;
    }));
    load.series.back().dashed = dashed;
  };
  add_load("linear", "linear", "#1f6fb4", load_error, false);
  add_load("linear", "calibrated limit", "#1f6fb4", calibrated_load_error, true);
  add_load("linear, graded", "graded", "#7fb2dd", load_error, false);
  add_load("six-node", "six-node", "#c0392b", load_error, false);
  add_load("six-node", "calibrated limit", "#c0392b", calibrated_load_error, true);
  add_load("six-node, graded", "graded", "#e3988f", load_error, false);

  riprap::Chart angle{"Crack: error in one of ten particles, linear triangles",
                      "sampling points [-]",
                      "90 % quantile of the angle [degrees]",
                      {},
                      riprap::AxisScale::logarithmic};
  const std::array colours{"#1f6fb4", "#15803d", "#c0392b", "#b8860b"};
  const std::array names{"X or Y", "least squares", "mean tension", "by mean stress"};
  for (std::size_t k = 0; k < line_names.size(); ++k)
    angle.series.push_back(series("linear", names[k], colours[k], [&](const MeshChoice& choice) {
      return spread(values_of(sets, is_usual, choice,
                              [&](const Measurement& m) { return angle_error(m, k); }))
          .ninth;
    }));
  return riprap::chart_sheet({load, angle});
}

}  // namespace convergence
