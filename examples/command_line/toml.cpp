// SPDX-License-Identifier: BSL-1.0
#include "toml.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include <riprap/core/errors.hpp>

namespace command_line {

namespace {

constexpr auto blanks = " \t\r\n";

[[noreturn]] void fail(const std::string& rule) { throw riprap::InvalidInput(rule); }

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

// Blanks, ends of lines and comments.
void skip_blanks(std::string_view& text) {
  while (!text.empty()) {
    if (text.front() == '#')
      text.remove_prefix(std::min(text.find('\n'), text.size()));
    else if (std::string_view(blanks).find(text.front()) != std::string_view::npos)
      text.remove_prefix(1);
    else
      return;
  }
}

// Takes "..." with escapes, '...' without, or a word that ends before one of `ends`.
std::string take_item(std::string_view& text, std::string_view ends) {
  const bool is_string = text.starts_with('"') || text.starts_with('\'');
  const std::size_t end =
      is_string ? end_of_string(text) : std::min(text.find_first_of(ends), text.size());
  if (end == text.npos) fail("the string has no end");
  const std::string value(text.substr(0, end));
  if (value.empty()) fail("a value is missing");
  if (value.find_first_of("[{") == 0) fail("arrays and tables have no meaning here");
  text.remove_prefix(end);
  if (value.front() == '\'') return value.substr(1, value.size() - 2);
  if (!is_string) return value;
  // Strings of TOML with their escapes are strings of JSON.
  const auto string = nlohmann::json::parse(value, nullptr, false);
  if (!string.is_string()) fail(value + " is not a string");
  return string.get<std::string>();
}

TomlValue take_list(std::string_view& text) {
  TomlValue list{{}, true};
  text.remove_prefix(1);
  for (skip_blanks(text); !text.starts_with(']'); skip_blanks(text)) {
    if (text.empty()) fail("the list has no end");
    list.items.push_back(take_item(text, " \t\r\n#,]"));
    skip_blanks(text);
    if (text.starts_with(','))
      text.remove_prefix(1);
    else if (!text.empty() && !text.starts_with(']'))
      fail("',' or ']' must come after '" + list.items.back() + "'");
  }
  text.remove_prefix(1);
  return list;
}

}  // namespace

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == text.npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(blanks) - first + 1));
}

TomlValue toml_value(std::string_view text) {
  skip_blanks(text);
  TomlValue value;
  if (text.starts_with('['))
    value = take_list(text);
  else
    value.items.push_back(take_item(text, " \t#"));
  const std::string rest = trimmed(text);
  if (!rest.empty() && rest.front() != '#') fail("'" + rest + "' after the value");
  return value;
}

bool is_open_list(std::string_view text) {
  if (!trimmed(text).starts_with('[')) return false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == ']') return false;
    if (c == '#') i = std::min(text.find('\n', i), text.size());
    if (c != '"' && c != '\'') continue;
    const std::size_t end = end_of_string(text.substr(i));
    if (end == text.npos) return false;  // what reads it says so
    i += end - 1;
  }
  return true;
}

}  // namespace command_line
