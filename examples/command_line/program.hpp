// SPDX-License-Identifier: BSL-1.0
#pragma once
// What all examples with options have in common: --help, --version, and three exit codes.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

#include <riprap/core/errors.hpp>
#include <riprap/core/version.hpp>

#include "option_names.hpp"

namespace command_line {

enum ExitCode {
  finished = 0,
  failed = 1,  // or interrupted
  wrong_command = 2
};

// Calls `parse()`, which throws CLI::ParseError for --help, --version and a command that is wrong:
// exits with 0 in the first two cases, with 2 in the last.
template <class Parse>
void parse_or_exit(CLI::App& app, Parse&& parse) {
  app.set_version_flag("--version", "riprap " + std::string(riprap::version),
                       "print the version and exit");
  try {
    parse();
  } catch (const CLI::ParseError& error) {
    std::exit(app.exit(error) == 0 ? finished : wrong_command);
  }
}

// Calls `program()`, which gives back an exit code, and prints what it throws: input that breaks a
// rule makes the command wrong, anything else means that the program failed.
template <class Program>
int run_program(const OptionNames& names, Program&& program) {
  try {
    return program();
  } catch (const riprap::InvalidInput& error) {
    std::fprintf(stderr, "error: %s\n", in_options(error.what(), names).c_str());
    return wrong_command;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", in_options(error.what(), names).c_str());
    return failed;
  }
}

}  // namespace command_line
