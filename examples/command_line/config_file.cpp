// SPDX-License-Identifier: BSL-1.0
// Options from a file.

#include "config_file.hpp"

#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string_view>

#include <riprap/core/errors.hpp>

#include "toml.hpp"

namespace command_line {

namespace {

[[noreturn]] void fail(const std::string& place, const std::string& what) {
  throw CLI::ValidationError("--config", place + ": " + what);
}

// One value; a list has no meaning.
std::string one_value(std::string_view text, const std::string& place) {
  TomlValue value;
  try {
    value = toml_value(text);
  } catch (const riprap::InvalidInput& error) {
    fail(place, error.what());
  }
  if (value.is_list) fail(place, "arrays and tables have no meaning here");
  return value.items.front();
}

}  // namespace

void ConfigFile::add(std::vector<CLI::ConfigItem>& read, const std::string& name,
                     const std::string& value, const std::string& place) const {
  const CLI::Option* option = name.empty() ? nullptr : app_.get_option_no_throw("--" + name);
  if (option == nullptr || !option->get_configurable())
    fail(place, "'" + name + "' is not the name of an option, without its dashes");
  for (const CLI::ConfigItem& item : read)
    if (item.name == name) fail(place, "'" + name + "' comes twice");
  CLI::ConfigItem item;
  item.name = name;
  item.inputs = {value};
  read.push_back(std::move(item));
}

std::vector<CLI::ConfigItem> ConfigFile::from_toml(const std::string& text) const {
  std::vector<CLI::ConfigItem> read;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    line = trimmed(line);
    if (line.empty() || line.front() == '#') continue;
    const std::string place = "line " + std::to_string(number);
    const std::size_t equals = line.find('=');
    if (equals == line.npos) fail(place, "'" + line + "' is not NAME = VALUE");
    add(read, trimmed(std::string_view(line).substr(0, equals)),
        one_value(std::string_view(line).substr(equals + 1), place), place);
  }
  return read;
}

std::vector<CLI::ConfigItem> ConfigFile::from_json(const std::string& text) const {
  using Json = nlohmann::json;
  std::set<std::string> names;
  const auto check_name = [&](int, Json::parse_event_t event, Json& parsed) {
    if (event == Json::parse_event_t::key && !names.insert(parsed.get<std::string>()).second)
      fail("JSON", "'" + parsed.get<std::string>() + "' comes twice");
    return true;
  };
  Json file;
  try {
    file = Json::parse(text, check_name);
  } catch (const Json::parse_error& error) {
    fail("JSON, byte " + std::to_string(error.byte), "this is no object of names and values");
  }
  std::vector<CLI::ConfigItem> read;
  for (const auto& [name, value] : file.items()) {
    if (value.is_structured() || value.is_null())
      fail("JSON", "'" + name + "' is neither a string, a number nor true or false");
    add(read, name, value.is_string() ? value.get<std::string>() : value.dump(), "JSON");
  }
  return read;
}

std::vector<CLI::ConfigItem> ConfigFile::from_config(std::istream& input) const {
  const std::string text{std::istreambuf_iterator<char>(input), {}};
  return trimmed(text).starts_with('{') ? from_json(text) : from_toml(text);
}

void add_config_option(CLI::App& app) {
  app.set_config("--config", "", "options from a file, TOML or JSON; those of the command win")
      ->type_name("FILE");
  app.config_formatter(std::make_shared<ConfigFile>(app));
}

void check_config_option(const CLI::App& app) {
  const CLI::Option* option = app.get_config_ptr();
  if (option->count() > 0 && option->as<std::string>().empty())
    throw CLI::ValidationError("--config", "must not be empty");
}

}  // namespace command_line
