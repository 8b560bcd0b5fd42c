// SPDX-License-Identifier: BSL-1.0
#pragma once
// The options of the replay.

#include <string>

#include "../command_line/option_names.hpp"

namespace replay {

struct Options {
  std::string folder{};  // of the run, or the one in it that has the frames
  std::string out{};     // empty: replay.html in the folder
  unsigned every = 1;
  command_line::OptionNames names{};

  [[nodiscard]] std::string frames_file() const;
  [[nodiscard]] std::string out_file() const;
  // The name of the folder of the run.
  [[nodiscard]] std::string title() const;
};

// Exits on --help, --version and a command that is wrong.
Options read_options(int argc, char** argv);

}  // namespace replay
