// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <riprap/core/random.hpp>
#include <riprap/output/csv.hpp>
#include <support/extreme_numbers.hpp>
#include <support/near.hpp>
#include <support/still_sample.hpp>
#include <support/temporary_file.hpp>

using namespace riprap;
using test::near_relative;

namespace {

/// A table read back: a map from column to cell for every row.
struct Table {
  std::vector<std::string> header;
  std::vector<std::map<std::string, std::string>> rows;

  explicit Table(const std::string& text) {
    std::size_t begin = 0;
    while (begin < text.size()) {
      const std::size_t end = text.find('\n', begin);
      if (end == std::string::npos) throw std::runtime_error("the last line does not end");
      const auto cells = split(text.substr(begin, end - begin));
      begin = end + 1;
      if (header.empty()) {
        header = cells;
        continue;
      }
      if (cells.size() != header.size()) throw std::runtime_error("row of another length");
      rows.emplace_back();
      for (std::size_t c = 0; c < cells.size(); ++c) rows.back()[header[c]] = cells[c];
    }
  }
  [[nodiscard]] double number(std::size_t row, const std::string& column) const {
    return parsed(rows.at(row).at(column));
  }

  static double parsed(const std::string& text) {
    double value = 0;
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, value);
    if (result.ec != std::errc() || result.ptr != end)
      throw std::runtime_error("not a number: '" + text + "'");
    return value;
  }

 private:
  static std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> cells(1);
    for (const char c : line)
      if (c == ',')
        cells.emplace_back();
      else
        cells.back() += c;
    return cells;
  }
};

using Cells = std::map<std::string, double>;

/// Records of an uneven sample under growing load, in shear.
Curve uneven_curve(int records) {
  Curve curve;
  test::StillSample sample{
      test::Cross{.depths = {2.7e-5, 1e-5, -1e-5, 2.3e-5}, .slide = 1.3e-3, .turn = 0.3}};
  auto view = test::view_of(sample);
  view.stage_index = 11;
  curve.begin_stage(view);
  for (int k = 0; k < records; ++k) {
    sample.set_loss(1e-4);
    sample.slide(1.7e-6);
    curve.after_forces(sample);
    curve.before_splits(sample);
    sample.body(0).velocity = {0.003, 0.001 * k};
    curve.after_splits(sample);
    sample.work() = {0.31 + 0.1 * k, 0.017 * k, 0.0023 * k};
    sample.breaks().resize(static_cast<std::size_t>(2 * k));
    view.stretch = {1 + 0.007 * k, 1 - 0.011 * k};
    view.rate = {0, 0.123};
    curve.record(view);
  }
  return curve;
}

Cells curve_cells(const CurvePoint& p) {
  const Fabric& f = p.fabric;
  return {{"axial_strain", p.axial_strain},
          {"volumetric_strain", p.volumetric_strain},
          {"porosity", p.porosity},
          {"sigma_11", p.stress.s11},
          {"sigma_22", p.stress.s22},
          {"sigma_12", p.stress.s12},
          {"sin_phi", p.sin_phi()},
          {"sin_phi_inner", p.inner_sin_phi()},
          {"contacts_per_particle", p.coordination.contacts_per_particle},
          {"coordination_number", p.coordination.coordination_number},
          {"particles", static_cast<double>(p.particles)},
          {"breakages", static_cast<double>(p.breakages)},
          {"a", f.normals.coefficient},
          {"a_n", f.normal_forces.coefficient},
          {"a_t", f.tangential_forces.coefficient},
          {"b_n", f.normal_branches.coefficient},
          {"b_t", f.tangential_branches.coefficient},
          {"theta_0", f.normals.direction},
          {"theta_f", f.normal_forces.direction},
          {"theta_t", f.tangential_forces.direction},
          {"sin_phi_fabric", p.sin_phi_fabric()},
          {"sin_phi_fabric_simplified", p.sin_phi_fabric_simplified()},
          {"sin_phi_fabric_full", p.sin_phi_fabric_full()},
          {"inertial_number", p.inertial_number},
          {"unbalanced_force", p.state.unbalanced_force},
          {"overlap_ratio", p.overlap_ratio},
          {"kinetic_ratio", p.state.kinetic_ratio()},
          {"energy_error", p.energy_error()},
          {"lost_particles", static_cast<double>(p.lost_particles)},
          {"stage_index", static_cast<double>(p.stage_index)}};
}

Cells energy_cells(const CurvePoint& p) {
  const EnergyTerms& e = p.energy;
  return {{"axial_strain", p.axial_strain},
          {"boundary_work", e.boundary_work},
          {"body_force_work", e.body_force_work},
          {"kinetic", e.kinetic},
          {"stored", e.stored},
          {"slip", e.slip},
          {"dashpot", e.dashpot},
          {"damping", e.damping},
          {"breakage", e.breakage},
          {"law_residual", e.law_residual},
          {"unclosed", e.unclosed()}};
}

void check_row(const Table& table, std::size_t row, const Cells& expected) {
  for (const auto& [column, value] : expected) {
    CAPTURE(column);
    CHECK(table.number(row, column) == value);
  }
}

BreakEvent break_of(const Ancestry& particle) {
  return {.step = 123456789012,
          .time = 0.25,
          .particle = particle,
          .failures = {.elements = 96, .failed = 48, .lowest_safety_factor = 0.1 + 0.2},
          .mode = FailureMode::tension,
          .line = {{0.1, -0.3}, {-0.6, 0.8}},
          .pieces = {500, 501},
          .areas = {1.25e-4, 3e-5}};
}

}  // namespace

TEST_CASE("a table is one line of names and one line per row, without blanks") {
  const std::vector<double> rows{0.1, -3, 1e300};
  const CsvColumns<double> columns{{"value", [](const double& v) { return to_text(v); }},
                                   {"double", [](const double& v) { return to_text(2 * v); }}};
  CHECK(csv_text(columns, rows) == "value,double\n0.1,0.2\n-3,-6\n1e+300,2e+300\n");
  CHECK(csv_text(columns, std::vector<double>{}) == "value,double\n");
}

TEST_CASE("every number of a table reads back as the same double") {
  Random random(7);
  std::vector<double> rows{0.0,
                           -0.0,
                           1.0 / 3,
                           std::numeric_limits<double>::min(),
                           std::numeric_limits<double>::max(),
                           std::numeric_limits<double>::denorm_min(),
                           std::numeric_limits<double>::infinity()};
  for (int i = 0; i < 1000; ++i)
    rows.push_back(random.uniform(-1, 1) * std::pow(10, random.uniform(-20, 20)));
  const Table table(
      csv_text(CsvColumns<double>{{"x", [](const double& v) { return to_text(v); }}}, rows));
  REQUIRE(table.rows.size() == rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    CHECK(table.number(i, "x") == rows[i]);
    CHECK(std::signbit(table.number(i, "x")) == std::signbit(rows[i]));
  }
}

TEST_CASE("the columns of curve.csv keep their published names and order") {
  const std::string text = curve_csv(Curve{});
  CHECK(text ==
        "axial_strain,volumetric_strain,porosity,sigma_11,sigma_22,sigma_12,sin_phi,sin_phi_inner,"
        "contacts_per_particle,coordination_number,particles,breakages,a,a_n,a_t,b_n,b_t,theta_0,"
        "theta_f,theta_t,sin_phi_fabric,sin_phi_fabric_simplified,sin_phi_fabric_full,"
        "inertial_number,unbalanced_force,overlap_ratio,kinetic_ratio,energy_error,"
        "lost_particles,stage_index\n");
}

TEST_CASE("curve.csv has a line per record, and each column holds what its name says") {
  const Curve curve = uneven_curve(4);
  const Table table(curve_csv(curve));
  REQUIRE(table.rows.size() == 4);
  for (std::size_t k = 0; k < 4; ++k) {
    const Cells expected = curve_cells(curve.points()[k]);
    CHECK(expected.size() == table.header.size());
    check_row(table, k, expected);
  }
}

TEST_CASE("no two columns of either table could be exchanged unnoticed in these tests") {
  const CurvePoint p = uneven_curve(4).points().back();
  const Cells cells = curve_cells(p);
  std::set<double> different;
  for (const auto& [column, value] : cells) different.insert(value);
  CHECK(different.size() == cells.size());
  different.clear();
  for (const auto& [column, value] : energy_cells(p)) different.insert(value);
  CHECK(different.size() == energy_cells(p).size());
  CHECK(different.count(0) == 0);
}

TEST_CASE("energy.csv has every term of the balance and what the terms leave over") {
  const std::string header = energy_csv(Curve{});
  CHECK(header ==
        "axial_strain,boundary_work,body_force_work,kinetic,stored,slip,dashpot,damping,breakage,"
        "law_residual,unclosed\n");
  const Curve curve = uneven_curve(3);
  const Table table(energy_csv(curve));
  REQUIRE(table.rows.size() == 3);
  for (std::size_t k = 0; k < 3; ++k) check_row(table, k, energy_cells(curve.points()[k]));
  // What is written closes: work in = where it went + unclosed, to round-off of the sum.
  const auto at = [&](const std::string& column) { return table.number(2, column); };
  CHECK(at("boundary_work") + at("body_force_work") ==
        near_relative(at("kinetic") + at("stored") + at("slip") + at("dashpot") + at("damping") +
                          at("breakage") + at("law_residual") + at("unclosed"),
                      1e-14));
}

TEST_CASE("with bonds energy.csv has one more column, what they have lost") {
  const Curve curve = uneven_curve(2);
  CHECK(energy_csv(Curve{}, true).ends_with(",unclosed,bonds\n"));
  const Table table(energy_csv(curve, true));
  CHECK(table.number(1, "bonds") == curve.points()[1].energy.bonds);
  CHECK(table.number(1, "unclosed") == Table(energy_csv(curve)).number(1, "unclosed"));
  // A point as of a bonded sample.
  CurvePoint point;
  point.energy.bonds = 0.25;
  CHECK(energy_columns(true).back().first == "bonds");
  CHECK(energy_columns(true).back().second(point) == "0.25");
}

TEST_CASE("breakages.csv lists particle, time, cause, place and pieces of every break") {
  const test::StillSample sample;
  auto view = test::view_of(sample);
  Curve curve;
  view.stage = Stage::hydrostatic;
  BreakEvent with_dust = break_of({.id = 7, .root = 7});
  with_dust.pieces[1] = no_particle;
  curve.record_break(view, with_dust);
  view.stage = Stage::shear;
  view.stretch.y() = 0.875;
  curve.record_break(view, break_of({.id = 500, .parent = 7, .root = 7, .generation = 1}));
  const Table table(breakages_csv(curve));
  CHECK(table.header ==
        std::vector<std::string>{"step", "stage", "axial_strain", "particle", "parent", "root",
                                 "generation", "rat", "lowest_safety_factor", "mode", "line_x",
                                 "line_y", "line_angle", "piece_1", "piece_2", "area_1", "area_2"});
  REQUIRE(table.rows.size() == 2);
  CHECK(table.rows[0].at("stage") == "hydrostatic");
  CHECK(table.rows[0].at("particle") == "7");
  // An intact particle has no parent: an empty cell, not a number that could be one.
  CHECK(table.rows[0].at("parent").empty());
  CHECK(table.rows[0].at("generation") == "0");
  CHECK(table.rows[0].at("piece_1") == "500");
  CHECK(table.rows[0].at("piece_2").empty());  // dust
  const auto& second = table.rows[1];
  CHECK(second.at("stage") == "shear");
  CHECK(second.at("parent") == "7");
  CHECK(second.at("root") == "7");
  CHECK(second.at("generation") == "1");
  CHECK(second.at("mode") == to_text(FailureMode::tension));
  CHECK(second.at("step") == "123456789012");
  check_row(table, 1,
            {{"axial_strain", 0.125},
             {"particle", 500},
             {"rat", 0.5},
             {"lowest_safety_factor", 0.1 + 0.2},
             {"line_x", 0.1},
             {"line_y", -0.3},
             {"line_angle", std::atan2(0.8, -0.6)},
             {"piece_1", 500},
             {"piece_2", 501},
             {"area_1", 1.25e-4},
             {"area_2", 3e-5}});
}

TEST_CASE("a curve without breaks has a table of breakages with names only") {
  CHECK(Table(breakages_csv(Curve{})).rows.empty());
}

TEST_CASE("write_csv writes the curve's table, and names the path where it cannot") {
  const test::TemporaryFile file;
  const Curve curve = uneven_curve(2);
  write_csv(file.path(), curve);
  CHECK(file.text() == curve_csv(curve));
  const std::string path = file.path() + "/curve.csv";  // below a file, which is no folder
  CHECK_THROWS_WITH_AS(write_csv(path, curve),
                       ("cannot write " + path + ": Not a directory").c_str(), SimulationError);
}

TEST_CASE("any number has a cell in a table") {
  const std::vector<double> rows(test::extreme_numbers.begin(), test::extreme_numbers.end());
  const Table table(
      csv_text(CsvColumns<double>{{"x", [](const double& v) { return to_text(v); }}}, rows));
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (std::isnan(rows[i]))
      CHECK(table.rows[i].at("x") == "nan");
    else
      CHECK(table.number(i, "x") == rows[i]);
}
