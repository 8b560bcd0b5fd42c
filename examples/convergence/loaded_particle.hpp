// SPDX-License-Identifier: BSL-1.0
#pragma once
// Particles with the contact forces of a biaxial test.

#include <cstdint>
#include <string>
#include <vector>

#include <riprap/core/vec2.hpp>

namespace convergence {

struct PointForce {
  riprap::Vec2 arm{0, 0};    // from the centroid [m]
  riprap::Vec2 force{0, 0};  // on the particle [N]
};

// In laboratory axes, with its centroid at the origin.
struct LoadedParticle {
  std::vector<riprap::Vec2> ring{};
  std::vector<PointForce> forces{};
};

struct Sample {
  double thickness = 0;  // [m]
  double mean_area = 0;  // of the intact particles [m^2]
  std::vector<LoadedParticle> particles{};
};

struct Test {
  double pressure = 8e6;  // [Pa]
  double strain = 0.04;   // axial, of shear
  std::uint64_t seed = 1;
  unsigned particles = 500;
  bool breakage = false;
};

// Free particles with three loaded contacts or more at the end of the test: of one without breakage
// all of them, of one with breakage pieces alone.
[[nodiscard]] Sample loaded_particles(const Test& test);

// As text; numbers keep all digits.
[[nodiscard]] std::string to_lines(const Sample& sample);
[[nodiscard]] Sample sample_from(const std::string& lines);

}  // namespace convergence
