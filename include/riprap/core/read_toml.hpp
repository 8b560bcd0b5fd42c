// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Reads tables of names and values, in the part of TOML that files of parameters need.

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/core/read_csv.hpp>

namespace riprap::internal {

/// A line NAME = VALUE.
struct TomlEntry {
  std::string key;    ///< with its dots
  std::string value;  ///< of a string, what is between the quotes
  bool is_string = false;
  std::size_t line = 0;
  bool used = false;
};

/// The entries under a header [NAME] or [[NAME]], or before the first one.
struct TomlTable {
  std::string name{};
  std::size_t line = 0;
  std::string file{};
  std::vector<TomlEntry> entries{};

  /// The entry of a key, marked as used; null if there is none.
  [[nodiscard]] const TomlEntry* find(std::string_view key) {
    for (TomlEntry& entry : entries)
      if (entry.key == key) {
        entry.used = true;
        return &entry;
      }
    return nullptr;
  }
  /// Throws InvalidInput "FILE, line N: WHAT".
  [[noreturn, gnu::cold]] void fail(std::size_t at, const std::string& what) const {
    throw InvalidInput(file + ", line " + std::to_string(at) + ": " + what);
  }
  [[noreturn, gnu::cold]] void fail(const TomlEntry& entry, const std::string& rule) const {
    const char* quote = entry.is_string ? "\"" : "";
    fail(entry.line, entry.key + " = " + quote + entry.value + quote + ": " + rule);
  }

  /// Takes the value of an entry: a number, true or false, a string, or one of the names of an
  /// enumeration, which `names_of` lists. Throws InvalidInput for anything else.
  template <class T>
  void take(const TomlEntry& entry, T& value) const {
    if constexpr (std::is_same_v<T, bool>) {
      if (entry.is_string || (entry.value != "true" && entry.value != "false"))
        fail(entry, "must be true or false");
      value = entry.value == "true";
    } else if constexpr (std::is_arithmetic_v<T>) {
      value = number<T>(entry);
    } else if constexpr (std::is_enum_v<T>) {
      value = static_cast<T>(place_in(entry, names_of(value)));
    } else {
      if (!entry.is_string) fail(entry, "must be text in double quotes");
      value = entry.value;
    }
  }
  /// The place of the text of an entry among names.
  template <class Names>
  [[nodiscard]] std::size_t place_in(const TomlEntry& entry, const Names& names) const {
    std::string all;
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (entry.is_string && entry.value == names[k]) return k;
      all += (k == 0 ? "\"" : ", \"") + std::string(names[k]) + "\"";
    }
    fail(entry, "must be one of " + all);
  }

 private:
  template <class T>
  [[nodiscard]] T number(const TomlEntry& entry) const {
    constexpr bool whole = std::is_integral_v<T>;
    const std::string_view text = entry.value;
    double value = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool is_number = !entry.is_string && read.ec == std::errc() &&
                           read.ptr == text.data() + text.size() && std::isfinite(value);
    if (!is_number) fail(entry, whole ? "must be a whole number" : "must be a finite number");
    if constexpr (whole) {
      // Numbers up to 2^53 are exact.
      if (value < 0 || value > 9007199254740992.0 || value != std::floor(value))
        fail(entry, "must be a whole number, 0 or above");
    }
    return static_cast<T>(value);
  }
};

/// Reads lines NAME = VALUE, [NAME], [[NAME]], and comments, which begin with #. Values are
/// numbers, true, false, and strings in double quotes without escapes.
class TomlReader {
 public:
  TomlReader(std::istream& in, std::string name) : lines_(in, std::move(name)) {}

  /// The first table has no name. Throws InvalidInput that names file, line and rule.
  [[nodiscard]] std::vector<TomlTable> tables() {
    std::vector<TomlTable> tables{{.file = lines_.name()}};
    while (lines_.next()) {
      if (lines_.line().starts_with('['))
        tables.push_back(header());
      else
        add_entry(tables.back());
    }
    return tables;
  }

 private:
  [[nodiscard]] TomlTable header() const {
    std::string_view text = lines_.line();
    text = trimmed(text.substr(0, text.find('#')));
    const std::size_t brackets = text.starts_with("[[") ? 2 : 1;
    const std::string_view close = brackets == 2 ? "]]" : "]";
    if (text.size() <= 2 * brackets || !text.ends_with(close))
      lines_.fail("'" + std::string(text) + "': must be [NAME] or [[NAME]]");
    const auto name = trimmed(text.substr(brackets, text.size() - 2 * brackets));
    return {.name = std::string(name), .line = lines_.number(), .file = lines_.name()};
  }

  void add_entry(TomlTable& table) const {
    const std::string_view text = lines_.line();
    const std::size_t equals = text.find('=');
    const std::string_view key = trimmed(text.substr(0, equals));
    if (equals == std::string_view::npos || key.empty())
      lines_.fail("'" + std::string(text) + "': must be NAME = VALUE");
    for (const TomlEntry& other : table.entries)
      if (other.key == key)
        lines_.fail(std::string(key) + ": comes twice, first in line " +
                    std::to_string(other.line));
    const auto [value, is_string] = value_of(key, trimmed(text.substr(equals + 1)));
    table.entries.push_back({std::string(key), std::string(value), is_string, lines_.number()});
  }

  [[nodiscard]] std::pair<std::string_view, bool> value_of(std::string_view key,
                                                           std::string_view text) const {
    const bool is_string = text.starts_with('"');
    const std::size_t end = is_string ? text.find('"', 1) : text.find('#');
    if (is_string && end == std::string_view::npos)
      lines_.fail(std::string(key) + " = " + std::string(text) + ": the string has no end");
    const auto value = is_string ? text.substr(1, end - 1) : trimmed(text.substr(0, end));
    if (is_string) {
      const auto rest = trimmed(text.substr(end + 1));
      if (!rest.empty() && !rest.starts_with('#'))
        lines_.fail(std::string(key) + ": '" + std::string(rest) + "' after the value");
    } else if (value.empty()) {
      lines_.fail(std::string(key) + ": a value is missing");
    }
    return {value, is_string};
  }

  LineReader lines_;
};

}  // namespace riprap::internal
