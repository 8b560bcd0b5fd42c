// SPDX-License-Identifier: BSL-1.0
#pragma once
// A biaxial test of a sample of strong and weak rock.

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace two_rocks {

enum Material : std::uint16_t { strong, weak };

// Parameters of a rock; the defaults are those of Table 1 of the paper.
struct RockOfSample {
  double compressive_strength = 300e6;  // [Pa]
  double m_b = 25;                      // of Hoek and Brown [-]
  double young = 70e9;                  // [Pa]
  double poisson = 0.17;                // [-]
  double density = 2500;                // [kg/m^3]
  double friction = 0.5;                // of contacts of the rock [-]
};

struct Mixture {
  double weak_share = 0;  // of the area of the free particles [-]
  unsigned particles = 300;
  double pressure = 8e6;  // [Pa]
  double strain = 0.2;    // axial, at the end [-]
  std::uint64_t seed = 1;
  RockOfSample rock{};
  RockOfSample weak_rock{};
};

// One record of shear; pairs are of the strong and the weak rock.
struct MixtureRecord {
  double strain = 0;               // axial [-]
  double sin_phi = 0;              // (s1 - s2) / (s1 + s2) [-]
  double volumetric_strain = 0;    // positive in contraction [-]
  std::array<double, 2> breaks{};  // since shear began
  std::array<double, 2> hardin{};  // B_r since the sample was made [-]; NaN where there is none
};

// Strength of a test: the largest mean of sin phi over five records, and the mean over those of the
// last quarter.
struct Strength {
  double peak = 0;
  double end = 0;
};
[[nodiscard]] Strength strength_of(const std::vector<MixtureRecord>& records);

// Writes pictures of the end by material and by parent, if `picture` is not empty.
[[nodiscard]] std::vector<MixtureRecord> run(const Mixture& mixture,
                                             const std::filesystem::path& picture);

// A line for each record, and back.
[[nodiscard]] std::string to_lines(const std::vector<MixtureRecord>& records);
[[nodiscard]] std::vector<MixtureRecord> from_lines(const std::string& text);
// All that a run depends on, in one line.
[[nodiscard]] std::string key_of(const Mixture& mixture);

}  // namespace two_rocks
