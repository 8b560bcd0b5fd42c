// SPDX-License-Identifier: BSL-1.0
#pragma once
// The options that the examples of shear tests have in common.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include <riprap/breakage/criterion/hoek_brown.hpp>
#include <riprap/contact/contact_law/energy_conserving_spring.hpp>
#include <riprap/dynamics/damping/local_damping.hpp>
#include <riprap/material/rock.hpp>
#include <riprap/particle/random_placement.hpp>

#include "../command_line/option_table.hpp"

namespace shear_tests {

// The parameters of the library are where the library has them, with its defaults.
struct Options {
  riprap::RandomAssembly assembly{};
  riprap::Rock rock{};
  riprap::EnergyConservingSpring contact{};
  riprap::LocalDamping damping{};
  riprap::HoekBrown criterion{};
  unsigned samples = 3;                   // at each normal stress, of seeds one apart
  std::vector<double> normal_stresses{};  // [Pa]
  double shear = 0;                       // at the end: a strain or a share of the width [-]
  double inertial_number = 1e-3;          // of shear, at the normal stress
  std::string breakage = "on";
  std::string out{};
  bool quick = false;

  [[nodiscard]] std::size_t runs() const { return samples * normal_stresses.size(); }
  // The shear rate [1/s] of the inertial number at a normal stress [Pa].
  [[nodiscard]] double rate(double normal_stress) const;
  // Throws riprap::InvalidInput for a value that breaks a rule.
  void validate() const;
};

// `shear` says what Options.shear is.
void add_options(command_line::OptionTable& table, Options& options, const std::string& shear);

// "1 MPa"
[[nodiscard]] std::string stress_text(double pascals);

}  // namespace shear_tests
