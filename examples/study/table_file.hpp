// SPDX-License-Identifier: BSL-1.0
#pragma once
// The file of a study, as it is written: options, lists of values, seeds. What they mean is not
// checked here.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace run_study {

// An option of the biaxial example, without its dashes, and its values.
struct Setting {
  std::string option;
  std::vector<std::string> values;
  bool is_list = false;  // of which every value makes runs of its own
  int line = 0;
};

// Every combination of the lists, with every seed.
struct TableRow {
  std::string name{};               // none: the options of the row name it
  std::vector<Setting> settings{};  // over those of the base
  std::vector<std::uint64_t> seeds{};
  int line = 0;
};

struct TableFile {
  std::string path;
  std::vector<Setting> base{};
  std::vector<TableRow> rows{};
};

// "runs.toml, line 3: "
std::string place(const TableFile& file, int line);

// Reads TOML, or CSV if the name of the file ends with .csv. Throws riprap::InvalidInput that names
// file, line, value and rule; riprap::SimulationError for a file that cannot be read.
TableFile read_table(const std::filesystem::path& path);
// The same for the text of a file.
TableFile table_from_toml(const std::string& path, const std::string& text);
TableFile table_from_csv(const std::string& path, const std::string& text);

}  // namespace run_study
