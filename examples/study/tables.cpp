// SPDX-License-Identifier: BSL-1.0
#include "tables.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <riprap/core/errors.hpp>

#include "../run_table/tasks.hpp"
#include "results.hpp"
#include "statistics.hpp"

namespace run_study {

namespace {

// Empty for what is not a number.
std::string cell(double value) { return std::isnan(value) ? "" : riprap::to_text(value); }

std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\n") == text.npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

// "row" if rows have names, and the options of the table.
std::vector<std::string> leading_columns(const Study& study) {
  std::vector<std::string> names = study.options;
  if (std::ranges::any_of(study.runs, [](const Run& run) { return !run.row.empty(); }))
    names.insert(names.begin(), "row");
  return names;
}

std::string interval_cells(const Statistics& s) {
  return "," + cell(s.mean) + "," + cell(s.low()) + "," + cell(s.high());
}

}  // namespace

std::string runs_csv(const Study& study, const std::vector<FinishedRun>& runs) {
  const std::vector<std::string> leading = leading_columns(study);
  std::string text = "run";
  for (const std::string& name : leading) text += "," + name;
  text += ",seed";
  for (const ResultColumn& column : result_columns()) text += std::string(",") + column.name;
  for (const FinishedRun& r : runs) {
    text += "\n" + cell(r.run->folder);
    for (const std::string& name : leading) text += "," + cell(value_of(*r.run, name));
    text += "," + std::to_string(r.run->seed);
    for (const double value : r.results) text += "," + cell(value);
  }
  return text + "\n";
}

std::string summary_csv(const Study& study, const std::vector<Combination>& all,
                        const std::optional<Against>& against) {
  const std::vector<std::string> leading = leading_columns(study);
  std::string text;
  for (const std::string& name : leading) text += name + ",";
  text += against ? "n,pairs" : "n";
  for (const ResultColumn& column : result_columns()) {
    const std::string name = std::string(",") + column.name;
    text += name + "_mean" + name + "_low" + name + "_high" + name + "_sd";
    if (against)
      text += name + "_difference" + name + "_difference_low" + name + "_difference_high";
  }
  for (const Combination& c : all) {
    text += "\n";
    for (const std::string& name : leading) text += cell(value_of(c.first(), name)) + ",";
    text += std::to_string(c.runs.size());
    const Combination* reference = against ? reference_of(c, *against, all) : nullptr;
    if (against)
      text += "," + (reference ? std::to_string(paired_differences(c, *reference, 0).size()) : "");
    for (std::size_t k = 0; k < result_columns().size(); ++k) {
      const Statistics s = statistics_of(c.values(k));
      text += interval_cells(s) + "," + cell(s.standard_deviation);
      if (!against) continue;
      text +=
          reference ? interval_cells(statistics_of(paired_differences(c, *reference, k))) : ",,,";
    }
  }
  return text + "\n";
}

std::string table_md(const Study& study, const std::vector<Combination>& all) {
  std::vector<std::string> leading = leading_columns(study);
  std::erase_if(leading, [&](const std::string& name) {
    std::set<std::string> values;
    for (const Combination& c : all) values.insert(value_of(c.first(), name));
    return values.size() < 2;
  });
  std::string text = "|";
  std::string rule = "\n|";
  const auto add_title = [&](const std::string& title) {
    text += " " + title + " |";
    rule += "---|";
  };
  std::ranges::for_each(leading, add_title);
  add_title("samples");
  for (const ResultColumn& column : result_columns())
    if (column.title) add_title(column.title);
  text += rule + "\n";
  for (const Combination& c : all) {
    text += "|";
    for (const std::string& name : leading) text += " " + value_of(c.first(), name) + " |";
    text += " " + std::to_string(c.runs.size()) + " |";
    for (std::size_t k = 0; k < result_columns().size(); ++k) {
      const ResultColumn& column = result_columns()[k];
      if (column.title)
        text += " " + run_table::cell(c.values(k), column.format, column.unit) + " |";
    }
    text += "\n";
  }
  return text;
}

}  // namespace run_study
