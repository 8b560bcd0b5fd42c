// SPDX-License-Identifier: BSL-1.0
// Options from a file.

#include "config_file.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string_view>

namespace command_line {

namespace {

constexpr auto blanks = " \t\r\n";

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == text.npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(blanks) - first + 1));
}

[[noreturn]] void fail(const std::string& place, const std::string& what) {
  throw CLI::ValidationError("--config", place + ": " + what);
}

// Where a string that begins with a quote ends, its closing quote included; npos if it does not.
std::size_t end_of_string(std::string_view text) {
  for (std::size_t i = 1; i < text.size(); ++i) {
    if (text[i] == '\\' && text[0] == '"')
      ++i;
    else if (text[i] == text[0])
      return i + 1;
  }
  return text.npos;
}

// "..." with escapes, '...' without, or a word; then nothing but a comment.
std::string toml_value(const std::string& text, const std::string& place) {
  const bool is_string = text.starts_with('"') || text.starts_with('\'');
  const std::size_t end =
      is_string ? end_of_string(text) : std::min(text.find_first_of(" \t#"), text.size());
  if (end == text.npos) fail(place, "the string has no end");
  const std::string rest = trimmed(std::string_view(text).substr(end));
  const std::string value = text.substr(0, end);
  if (!rest.empty() && rest.front() != '#') fail(place, "'" + rest + "' after the value");
  if (value.empty()) fail(place, "a value is missing");
  if (value.find_first_of("[{") == 0) fail(place, "arrays and tables have no meaning here");
  if (text.starts_with('\'')) return value.substr(1, value.size() - 2);
  if (!is_string) return value;
  // Strings of TOML with their escapes are strings of JSON.
  const auto string = nlohmann::json::parse(value, nullptr, false);
  if (!string.is_string()) fail(place, value + " is not a string");
  return string.get<std::string>();
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
        toml_value(trimmed(std::string_view(line).substr(equals + 1)), place), place);
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
  const std::size_t first = text.find_first_not_of(blanks);
  return first != text.npos && text[first] == '{' ? from_json(text) : from_toml(text);
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
