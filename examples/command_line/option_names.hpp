// SPDX-License-Identifier: BSL-1.0
#pragma once
// Errors of the library in the words of a command line.

#include <string>
#include <utility>
#include <vector>

namespace command_line {

// Which option sets which member: {"Rock.young", "--young"}.
using OptionNames = std::vector<std::pair<std::string, std::string>>;

// The message with every member's name replaced by the option's, also where a rule has the member
// without its struct ("must lie above solid_fraction").
std::string in_options(std::string message, const OptionNames& names);

}  // namespace command_line
