// SPDX-License-Identifier: BSL-1.0
#include "table_file.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <numeric>
#include <optional>
#include <set>
#include <sstream>

#include <riprap/core/errors.hpp>

#include "../command_line/number.hpp"
#include "../command_line/toml.hpp"

namespace run_study {

namespace {

using command_line::trimmed;

// More are a mistake.
constexpr std::uint64_t most_seeds = 100000;

[[noreturn]] void fail(const TableFile& file, int line, const std::string& what) {
  throw riprap::InvalidInput(place(file, line) + what);
}

std::uint64_t seed_from(const std::string& text) {
  const auto seed = command_line::number_from<std::uint64_t>(text);
  if (!seed)
    throw riprap::InvalidInput("seeds: '" + text + "' is not " +
                               command_line::rule_of_number<std::uint64_t>());
  return *seed;
}

// A list of seeds, or the number of those that are 1, 2, ...
std::vector<std::uint64_t> seeds_from(const command_line::TomlValue& value) {
  std::vector<std::uint64_t> seeds;
  for (const std::string& item : value.items) seeds.push_back(seed_from(item));
  if (value.is_list && !seeds.empty()) return seeds;
  if (value.is_list || seeds.front() < 1 || seeds.front() > most_seeds)
    throw riprap::InvalidInput("seeds: must be a list, or a count from 1 to " +
                               std::to_string(most_seeds));
  std::vector<std::uint64_t> counted(seeds.front());
  std::iota(counted.begin(), counted.end(), 1U);
  return counted;
}

// Reads a file in TOML from its first line to its last.
class TomlReader {
 public:
  explicit TomlReader(const std::string& path) : file_{path} {}

  TableFile read(const std::string& text) {
    std::istringstream lines(text);
    std::string line;
    while (std::getline(lines, line)) {
      const int begin = ++number_;
      line = trimmed(line);
      if (line.empty() || line.front() == '#') continue;
      if (line.front() == '[') {
        begin_section(trimmed(line.substr(0, line.find('#'))));
        continue;
      }
      const std::size_t equals = line.find('=');
      if (equals == line.npos) fail(file_, begin, "'" + line + "' is not NAME = VALUE");
      const std::string name = trimmed(line.substr(0, equals));
      std::string value = line.substr(equals + 1);
      for (; command_line::is_open_list(value) && std::getline(lines, line); ++number_)
        value += "\n" + line;
      try {
        add(name, command_line::toml_value(value), begin);
      } catch (const riprap::InvalidInput& error) {
        fail(file_, begin, error.what());
      }
    }
    return finished();
  }

 private:
  enum class Section { top, base, axes, row };

  void begin_section(const std::string& title) {
    if (title == "[[rows]]") {
      section_ = Section::row;
      file_.rows.push_back({.line = number_});
    } else if (title == "[base]" && !has_base_) {
      section_ = Section::base;
      has_base_ = true;
    } else if (title == "[axes]" && !axes_) {
      section_ = Section::axes;
      axes_ = TableRow{.line = number_};
    } else {
      fail(file_, number_, "'" + title + "' is none of [base], [axes], each once, and [[rows]]");
    }
  }

  // Throws riprap::InvalidInput without the place.
  void add(const std::string& name, const command_line::TomlValue& value, int line) {
    if (name == "seeds") {
      auto& seeds = section_ == Section::row ? file_.rows.back().seeds : seeds_;
      if (section_ == Section::base || section_ == Section::axes)
        throw riprap::InvalidInput("'seeds' stands before the first section, or in [[rows]]");
      if (!seeds.empty()) throw riprap::InvalidInput("'seeds' comes twice");
      seeds = seeds_from(value);
    } else if (name == "name" && section_ == Section::row) {
      if (value.is_list || value.items.front().empty() || !file_.rows.back().name.empty())
        throw riprap::InvalidInput("name: must be one text, once a row");
      file_.rows.back().name = value.items.front();
    } else if (section_ == Section::top) {
      throw riprap::InvalidInput("'" + name + "' stands before the first section, as 'seeds' only");
    } else {
      add_setting(settings(), {name, value.items, value.is_list, line});
    }
  }

  std::vector<Setting>& settings() {
    if (section_ == Section::base) return file_.base;
    return section_ == Section::axes ? axes_->settings : file_.rows.back().settings;
  }

  void add_setting(std::vector<Setting>& settings, const Setting& setting) const {
    for (const Setting& s : settings)
      if (s.option == setting.option) throw riprap::InvalidInput("'" + s.option + "' comes twice");
    if (setting.values.empty())
      throw riprap::InvalidInput(setting.option + ": the list must not be empty");
    if (section_ == Section::base && setting.is_list)
      throw riprap::InvalidInput(setting.option + ": a list belongs into [axes] or [[rows]]");
    if (section_ == Section::axes && !setting.is_list)
      throw riprap::InvalidInput(setting.option +
                                 ": must be a list here; one value belongs into [base]");
    settings.push_back(setting);
  }

  TableFile finished() {
    // Without rows the base alone is one.
    if (axes_ || file_.rows.empty())
      file_.rows.insert(file_.rows.begin(), axes_.value_or(TableRow{.line = 1}));
    for (TableRow& row : file_.rows)
      if (row.seeds.empty()) row.seeds = seeds_.empty() ? std::vector<std::uint64_t>{1} : seeds_;
    return std::move(file_);
  }

  TableFile file_;
  Section section_ = Section::top;
  int number_ = 0;
  bool has_base_ = false;
  std::optional<TableRow> axes_;
  std::vector<std::uint64_t> seeds_;
};

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream text(line + ",");
  std::string cell;
  while (std::getline(text, cell, ',')) cells.push_back(trimmed(cell));
  return cells;
}

}  // namespace

std::string place(const TableFile& file, int line) {
  return file.path + ", line " + std::to_string(line) + ": ";
}

TableFile table_from_toml(const std::string& path, const std::string& text) {
  return TomlReader(path).read(text);
}

TableFile table_from_csv(const std::string& path, const std::string& text) {
  TableFile file{path};
  std::vector<std::string> names;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    line = trimmed(line);
    if (line.empty() || line.front() == '#') continue;
    if (line.find('"') != line.npos) fail(file, number, "quotes have no meaning here");
    const std::vector<std::string> cells = cells_of(line);
    if (names.empty()) {
      names = cells;
      if (std::set<std::string>(names.begin(), names.end()).size() < names.size())
        fail(file, number, "a name comes twice");
      continue;
    }
    if (cells.size() != names.size())
      fail(file, number,
           std::to_string(cells.size()) + " cells: must be as many as names, " +
               std::to_string(names.size()));
    TableRow row{.seeds = {1}, .line = number};
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (cells[c].empty()) continue;  // the default
      if (names[c] == "seed") {
        const auto seed = command_line::number_from<std::uint64_t>(cells[c]);
        if (!seed)
          fail(file, number,
               "seed: '" + cells[c] + "' is not " + command_line::rule_of_number<std::uint64_t>());
        row.seeds = {*seed};
      } else if (names[c] == "name") {
        row.name = cells[c];
      } else {
        row.settings.push_back({names[c], {cells[c]}, false, number});
      }
    }
    file.rows.push_back(std::move(row));
  }
  return file;
}

TableFile read_table(const std::filesystem::path& path) {
  std::ifstream input(path, std::ios::binary);
  std::error_code ignored;
  if (!input || std::filesystem::is_directory(path, ignored))
    throw riprap::SimulationError("cannot read " + path.string());
  const std::string text{std::istreambuf_iterator<char>(input), {}};
  return path.extension() == ".csv" ? table_from_csv(path.string(), text)
                                    : table_from_toml(path.string(), text);
}

}  // namespace run_study
