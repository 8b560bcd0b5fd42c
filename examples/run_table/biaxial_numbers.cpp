// SPDX-License-Identifier: BSL-1.0
#include "biaxial_numbers.hpp"

#include <cstdio>
#include <sstream>
#include <stdexcept>

#include <riprap/output/file.hpp>

namespace run_table {

std::string to_lines(const BiaxialNumbers& numbers) {
  std::string text;
  for (const Column& column : columns) {
    char line[80];
    std::snprintf(line, sizeof line, "%s,%.17g\n", column.name, numbers.*column.value);
    text += line;
  }
  return text;
}

BiaxialNumbers numbers_of(const Task& task) {
  std::istringstream text(result_of(task).value_or(""));
  std::string line;
  BiaxialNumbers numbers;
  for (const Column& column : columns) {
    std::getline(text, line);
    const auto comma = line.find(',');
    if (comma == std::string::npos || line.substr(0, comma) != column.name)
      throw std::runtime_error(task.file.string() + ": no " + column.name + " in its place");
    numbers.*column.value = std::stod(line.substr(comma + 1));
  }
  return numbers;
}

std::string table(const std::vector<std::string>& first, const std::vector<Row>& rows) {
  std::string text = "|";
  std::string rule = "\n|";
  const auto add_title = [&](const std::string& title) {
    text += " " + title + " |";
    rule += "---|";
  };
  for (const std::string& title : first) add_title(title);
  for (const Column& column : columns)
    if (column.title) add_title(column.title);
  text += rule + "\n";
  for (const Row& row : rows) {
    text += "| " + row.title + " |";
    for (const Column& column : columns) {
      if (!column.title) continue;
      std::vector<double> values;
      for (const BiaxialNumbers& r : row.runs) values.push_back(r.*column.value);
      text += " " + cell(values, column.format, column.unit) + " |";
    }
    text += "\n";
  }
  return text;
}

void leave_table(const std::filesystem::path& folder, const std::vector<std::string>& first,
                 const std::vector<Row>& rows) {
  const std::string text = table(first, rows);
  riprap::write_file(folder / "table.md", text);
  std::fputs(text.c_str(), stdout);
}

}  // namespace run_table
