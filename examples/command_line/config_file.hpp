// SPDX-License-Identifier: BSL-1.0
#pragma once
// Options from a file: TOML, a line NAME = VALUE for each, or JSON, one object of names and values.
// Names are those of the options without their dashes.

#include <CLI/CLI.hpp>
#include <istream>
#include <string>
#include <vector>

namespace command_line {

class ConfigFile : public CLI::Config {
 public:
  explicit ConfigFile(const CLI::App& app) : app_(app) {}

  // Throws CLI::ValidationError that names the line, for a name that is no option, a name that
  // comes twice, and a value that is neither a string, a number nor true or false.
  std::vector<CLI::ConfigItem> from_config(std::istream& input) const override;
  // Files are written by OptionTable.
  std::string to_config(const CLI::App*, bool, bool, std::string) const override { return {}; }

 private:
  void add(std::vector<CLI::ConfigItem>& items, const std::string& name, const std::string& value,
           const std::string& place) const;
  [[nodiscard]] std::vector<CLI::ConfigItem> from_toml(const std::string& text) const;
  [[nodiscard]] std::vector<CLI::ConfigItem> from_json(const std::string& text) const;

  const CLI::App& app_;
};

// Adds --config FILE to a program whose other options can all come from a file. What stands in the
// command wins.
void add_config_option(CLI::App& app);
// Throws CLI::ValidationError for `--config ""`.
void check_config_option(const CLI::App& app);

}  // namespace command_line
