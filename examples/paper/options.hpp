// SPDX-License-Identifier: BSL-1.0
#pragma once
// The options of the study.

#include <string>

namespace study {

struct Options {
  std::string out;
  unsigned samples = 8;
  unsigned jobs = 1;
  bool quick = false;
};

// Fills the options from the command line; exits on --help and on unknown or malformed options.
Options read_options(int argc, char** argv);

}  // namespace study
