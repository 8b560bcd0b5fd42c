// SPDX-License-Identifier: BSL-1.0
// The option --resume.

#include "resume.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>

namespace command_line {

std::vector<std::string> with_resumed_options(std::vector<std::string> arguments,
                                              std::vector<std::string> beside) {
  const auto is_option = [](const std::string& argument, const std::string& name) {
    return argument == name || argument.starts_with(name + "=");
  };
  std::string folder;
  for (std::size_t k = 0; k < arguments.size(); ++k) {
    if (arguments[k].starts_with("--resume=")) folder = arguments[k].substr(9);
    if (arguments[k] == "--resume" && k + 1 < arguments.size()) folder = arguments[k + 1];
  }
  if (folder.empty()) return arguments;
  beside.insert(beside.end(), {"--resume", "--checkpoint-every", "--help", "--version"});
  std::string before;
  for (const std::string& argument : arguments) {
    const bool is_value = before.starts_with("--") && before.find('=') == before.npos;
    const bool allowed = argument.starts_with("--")
                             ? std::any_of(beside.begin(), beside.end(),
                                           [&](const auto& n) { return is_option(argument, n); })
                             : is_value || argument.starts_with('-');
    if (!allowed)
      throw CLI::ValidationError(argument, "does not go with --resume, which takes the options of "
                                           "the run that goes on");
    before = argument;
  }
  for (const std::string& more :
       {std::string("--config"), folder + "/parameters.toml", std::string("--out"), folder})
    arguments.push_back(more);
  return arguments;
}

}  // namespace command_line
