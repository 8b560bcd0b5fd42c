// SPDX-License-Identifier: BSL-1.0
#pragma once
// The options of the single-particle example and the case they stand for.

#include <string>
#include <vector>

#include "../command_line/option_names.hpp"
#include "analysis.hpp"

namespace single_particle {

struct Options {
  std::string polygon;              // "x y, x y, ..." [m]
  std::string wkt;                  // name of a file
  std::vector<std::string> forces;  // "x y fx fy" [m, N]
  std::string criterion = "hoek-brown";
  std::string support = "inertia-relief";
  riprap::UniformMesher mesher{};
  double thickness = 0.016;
  riprap::FailedElementRatio trigger{};
  std::string out = "single_particle.svg";

  command_line::OptionNames names{};  // which option sets which member, for errors
};

// Exits on --help, --version and a command that is wrong.
Options read_options(int argc, char** argv);

// Throws InvalidInput for a polygon, a force or a parameter that breaks a rule.
Case chosen_case(const Options& options);

}  // namespace single_particle
