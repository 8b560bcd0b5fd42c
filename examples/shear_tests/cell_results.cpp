// SPDX-License-Identifier: BSL-1.0
#include "cell_results.hpp"

#include <cmath>
#include <utility>

#include <riprap/output/csv.hpp>

#include "../run_table/progress_line.hpp"

namespace shear_tests {

double CellPlan::work() const { return 1 / (test.inertial_number * std::sqrt(test.normal_stress)); }

std::vector<CellSeries> run_cells(const Options& o, const std::vector<CellPlan>& plans) {
  double all_work = 0;
  for (const CellPlan& p : plans) all_work += o.samples * p.work();
  run_table::ProgressLine line(all_work);
  std::vector<CellSeries> all;
  for (const CellPlan& p : plans) {
    CellSeries& series = all.emplace_back(CellSeries{.name = p.name});
    for (unsigned k = 0; k < o.samples; ++k) {
      CellTest test = p.test;
      test.seed += k;
      line.begin(p.name + ", seed " + std::to_string(test.seed), p.work());
      series.results.push_back(sheared_cell(o, test, [&](double share) { line.at(share); }));
    }
  }
  line.end();
  return all;
}

std::string table(const std::vector<CellSeries>& all) {
  using Row = std::pair<const CellResult*, const CellRecord*>;
  using riprap::to_text;
  const riprap::CsvColumns<Row> columns{
      {"normal_stress", [](const Row& r) { return to_text(r.first->test.normal_stress); }},
      {"inertial_number", [](const Row& r) { return to_text(r.first->test.inertial_number); }},
      {"seed", [](const Row& r) { return std::to_string(r.first->test.seed); }},
      {"shear_strain", [](const Row& r) { return to_text(r.second->strain); }},
      {"stress_11", [](const Row& r) { return to_text(r.second->stress.s11); }},
      {"stress_22", [](const Row& r) { return to_text(r.second->stress.s22); }},
      {"stress_12", [](const Row& r) { return to_text(r.second->stress.s12); }},
      {"asymmetry", [](const Row& r) { return to_text(r.second->asymmetry); }},
      {"rise", [](const Row& r) { return to_text(r.second->rise); }},
      {"work", [](const Row& r) { return to_text(r.second->work); }},
      {"work_of_stress", [](const Row& r) { return to_text(r.second->stress_work); }},
      {"breakages", [](const Row& r) { return std::to_string(r.second->breakages); }},
      {"particles", [](const Row& r) { return std::to_string(r.second->particles); }},
      {"broken", [](const Row& r) { return to_text(r.second->broken); }},
      {"detached", [](const Row& r) { return to_text(r.second->detached); }}};
  std::vector<Row> rows;
  for (const CellSeries& s : all)
    for (const CellResult& r : s.results)
      for (const CellRecord& rec : r.records) rows.emplace_back(&r, &rec);
  return riprap::csv_text(columns, rows);
}

Json options_json(const Options& o) {
  return {{"particles", o.assembly.count},
          {"first_seed", o.assembly.seed},
          {"samples", o.samples},
          {"friction", o.contact.friction},
          {"compressive_strength_Pa", o.criterion.compressive_strength},
          {"breakage", o.breakage},
          {"damping", o.damping.coefficient},
          {"shear_strain", o.shear},
          {"normal_stresses_Pa", o.normal_stresses}};
}

}  // namespace shear_tests
