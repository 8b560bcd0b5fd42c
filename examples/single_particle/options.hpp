// SPDX-License-Identifier: BSL-1.0
#pragma once
// The options of the single-particle example and the case they stand for.

#include <string>
#include <vector>

#include "analysis.hpp"

struct Options {
  std::string polygon;              // "x y, x y, ..." [m]
  std::string wkt;                  // name of a file
  std::vector<std::string> forces;  // "x y fx fy" [m, N]
  std::string criterion = "hoek-brown";
  std::string support = "inertia-relief";
  unsigned mesh_triangles = 100;
  double thickness = 0.016;
  double ratf = 0.4;
  std::string out = "single_particle.svg";
};

// Fills the options from the command line; exits on --help and on unknown or malformed options.
Options read_options(int argc, char** argv);

// Throws InvalidInput for a polygon, a force or a parameter that breaks a rule.
Case chosen_case(const Options& options);

// The polygon in a file of well-known text; its ring may turn either way.
riprap::ConvexPolygon read_wkt_file(const std::string& name);
