// SPDX-License-Identifier: BSL-1.0
#pragma once
// The part of TOML that files of options and tables of runs are written in.

#include <string>
#include <string_view>
#include <vector>

namespace command_line {

// Without blanks, tabs and ends of lines around it.
std::string trimmed(std::string_view text);

// A string, a number or a word, as text; or a list of these.
struct TomlValue {
  std::vector<std::string> items;
  bool is_list = false;
};

// What stands right of the "=", with a comment or without. Throws riprap::InvalidInput, without the
// place, for what is no value or has something behind it.
TomlValue toml_value(std::string_view text);

// Is `text` the beginning of a list that goes on in the next line?
bool is_open_list(std::string_view text);

}  // namespace command_line
