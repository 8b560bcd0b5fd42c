// SPDX-License-Identifier: BSL-1.0
#pragma once
// The option --resume, which goes on with a run.

#include <string>
#include <vector>

namespace command_line {

// The command that goes on with a run, for one with --resume: its folder as --out, and its file of
// parameters as --config. Throws CLI::ValidationError for an option that is none of `beside` and
// would change it.
std::vector<std::string> with_resumed_options(std::vector<std::string> arguments,
                                              std::vector<std::string> beside);

}  // namespace command_line
