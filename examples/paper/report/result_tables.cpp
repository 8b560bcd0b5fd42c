// SPDX-License-Identifier: BSL-1.0
#include "result_tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "../claims/evidence.hpp"
#include "../results/curve_features.hpp"

namespace report {

namespace {

std::string number(const char* format, double value) {
  char buffer[48];
  std::snprintf(buffer, sizeof buffer, format, value + 0.0);
  return buffer;
}

// "0.601 (0.585 to 0.624)".
std::string range(const Results& results, Mode mode, double pressure, const Feature& feature,
                  const char* format) {
  const std::vector<double> all = values(results, mode, pressure, feature);
  if (all.empty()) return "";
  const std::string mean = number(format, estimate(all).mean);
  if (all.size() == 1) return mean;
  const auto [least, most] = std::minmax_element(all.begin(), all.end());
  const std::string low = number(format, *least);
  const std::string high = number(format, *most);
  return low == high ? mean : mean + " (" + low + " to " + high + ")";
}

struct Column {
  std::string name;
  const char* format;
  Feature feature;
};

// A row a series.
Table table_of(const Results& results, const std::vector<Column>& columns) {
  Table table{{"", "samples"}, {}};
  for (const Column& c : columns) table.head.push_back(c.name);
  for (const Mode mode : {Mode::nb, Mode::wb})
    for (const double pressure : pressures) {
      const std::size_t samples = results.of(mode, pressure).size();
      if (samples == 0) continue;
      table.rows.push_back(
          {to_text(mode) + ", " + pressure_text(pressure), std::to_string(samples)});
      for (const Column& c : columns)
        table.rows.back().push_back(range(results, mode, pressure, c.feature, c.format));
    }
  return table;
}

struct Parameter {
  const char* name;
  const char* path;
  double factor;
  const char* unit;
  const char* remark;
};

constexpr auto table_1 = "Table 1";

constexpr std::array parameters{
    Parameter{"normal stiffness", "/motion/normal_stiffness_N_m", 1, "N/m", table_1},
    Parameter{"tangential stiffness", "/motion/tangential_stiffness_N_m", 1, "N/m", table_1},
    Parameter{"density", "/rock/density_kg_m3", 1, "kg/m³",
              "Table 1, where it is called a unit weight; there is no gravity"},
    Parameter{"friction coefficient", "/motion/friction", 1, "", table_1},
    Parameter{"modulus of elasticity", "/rock/young_Pa", 1e-9, "GPa", table_1},
    Parameter{"Poisson's ratio", "/rock/poisson", 1, "", table_1},
    Parameter{"compressive strength", "/breakage/compressive_strength_Pa", 1e-6, "MPa", table_1},
    Parameter{"m_b", "/breakage/m_b", 1, "", table_1},
    Parameter{"S", "/breakage/s", 1, "", table_1},
    Parameter{"a_b", "/breakage/a_b", 1, "", table_1},
    Parameter{"critical Rat, RatF", "/breakage/ratf", 1, "", "the paper, section 3.2"},
    Parameter{"particles", "/assembly/particles", 1, "", "the paper has at least 500"},
    Parameter{"axial strain", "/test/axial_strain", 100, "%", "the paper, section 3.3"},
    Parameter{"mean diameter", "/assembly/mean_diameter_m", 1e3, "mm",
              "open in the paper; only its ratio to the thickness matters"},
    Parameter{"thickness", "/assembly/thickness_m", 1e3, "mm",
              "open; decides how stiff contacts are beside the pressure, and gives contact forces "
              "of the size of the paper's Fig. 11"},
    Parameter{"diameters over the mean", "/assembly/diameters", 1, "", "open"},
    Parameter{"corners of a particle", "/assembly/vertices", 1, "",
              "open; sharp, as the title says: with blunt particles pieces are sharper than what "
              "they came from, and breakage raises the strength"},
    Parameter{"axis ratios of a particle", "/assembly/axis_ratios", 1, "", "open"},
    Parameter{"inertial number in shear", "/test/inertial_number", 1, "",
              "in place of Table 1's strain rate of 0.005 %, which has no unit of time; half of it "
              "below 1 MPa"},
    Parameter{"local damping", "/motion/local_damping", 1, "", "open"},
    Parameter{"time step over sqrt(m / k)", "/motion/time_step_fraction", 1, "",
              "open; k is the peak stiffness, twice the normal stiffness"},
    Parameter{"triangles of a particle's mesh", "/breakage/mesh_triangles", 1, "",
              "open; a finer mesh raises Rat by some hundredths"},
    Parameter{"smallest piece over the mean area", "/breakage/minimum_piece_area", 1, "",
              "open; with the next it decides how many breakages there are"},
    Parameter{"largest aspect of a piece", "/breakage/maximum_piece_aspect", 1, "", "open"},
    Parameter{"stress check every", "/breakage/check_every", 1, "steps", "the paper, section 3"}};

std::string value_text(const Json& value, double factor) {
  if (!value.is_array()) return number("%.4g", factor * value.get<double>());
  std::string out;
  for (const Json& v : value) out += (out.empty() ? "" : " to ") + value_text(v, factor);
  return out;
}

}  // namespace

Table parameters_table(const Json& given) {
  Table table{{"parameter", "value", "source, or why"}, {}};
  for (const Parameter& p : parameters) {
    const Json::json_pointer path(p.path);
    std::string value = "not recorded";
    if (given.contains(path)) {
      value = value_text(given.at(path), p.factor);
      if (*p.unit != 0) value += std::string(" ") + p.unit;
    }
    table.rows.push_back({p.name, value, p.remark});
  }
  return table;
}

Table results_table(const Results& results) {
  const auto gap = [](const char* name) {
    return [name](const Run& run) { return mean_gap(run, name); };
  };
  return table_of(
      results,
      {{"largest sin phi", "%.3f", [](const Run& r) { return largest(r, "sin_phi"); }},
       {"at axial strain [%]", "%.1f",
        [](const Run& r) { return 100 * smooth_peak(r, "sin_phi").strain; }},
       {"sin phi at the end", "%.3f", [](const Run& r) { return at_end(r, "sin_phi"); }},
       {"volumetric strain at the end [%]", "%.1f",
        [](const Run& r) { return 100 * at_end(r, "volumetric_strain"); }},
       {"coordination number 2M/N at the end", "%.2f",
        [](const Run& r) { return at_end(r, "coordination_number"); }},
       {"breakages", "%.0f", [](const Run& r) { return static_cast<double>(r.breaks.size()); }},
       {"gap of eq. 14", "%.3f", gap("sin_phi_eq_14")},
       {"gap of eq. 15", "%.3f", gap("sin_phi_eq_15")},
       {"gap of the full relation", "%.3f", gap("sin_phi_full")}});
}

Table quality_table(const Results& results) {
  const auto of = [](const char* name) {
    return [name](const Run& run) { return run.number(name); };
  };
  return table_of(
      results,
      {{"kappa", "%.1e", of("kappa")},
       {"largest overlap over diameter", "%.4f", of("overlap_ratio_largest")},
       {"largest inertial number", "%.1e", of("inertial_number_largest")},
       {"largest kinetic over stored energy", "%.1e", of("kinetic_ratio_largest_after_1_percent")},
       {"mean error of the confining pressure", "%.1e", of("confinement_error_mean")},
       {"energy not accounted for", "%.1e", of("energy_error")},
       {"fracture energy over boundary work [%]", "%.2f",
        [](const Run& r) {
          return 100 * r.fracture_energy(fracture_energy_per_area) / r.number("boundary_work_J");
        }},
       {"lost particles", "%.0f", of("lost_particles")},
       {"time [s]", "%.0f", [](const Run& r) { return r.wall_time; }}});
}

}  // namespace report
