// SPDX-License-Identifier: BSL-1.0
#pragma once
// What the command line says of the tests.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "../command_line/option_names.hpp"

namespace paths {

struct Options {
  std::string test;  // of a TestCase, "all", or a file of a path; empty: they are to be listed
  unsigned particles = 300;
  unsigned samples = 3;    // of the seeds seed, seed + 1, ...
  std::uint64_t seed = 1;  // of the first sample
  bool quick = false;      // shorter ready-made paths
  std::string out = "paths";
  std::string resume{};  // the folder of a command that was stopped; then `out` as well
  unsigned checkpoint_every = 0;
  command_line::OptionNames names{};
  std::string toml{};  // a file with which --resume goes on

  // Is the path that of a file?
  [[nodiscard]] bool reads_file() const { return test.ends_with(".toml"); }
  // That of this name, without ".toml".
  [[nodiscard]] std::string path_name() const {
    return std::filesystem::path(test).stem().string();
  }
  // A copy of it with which --resume goes on.
  [[nodiscard]] std::filesystem::path path_copy() const {
    return std::filesystem::path(out) / ("file_" + path_name()) / "path.toml";
  }
};

// Exits for --help, --version and a command that is wrong.
Options read_options(int argc, char** argv, const std::vector<std::string>& tests);

}  // namespace paths
