// SPDX-License-Identifier: BSL-1.0
#pragma once
// The options of the biaxial example.

#include <string>
#include <vector>

#include <riprap/riprap.hpp>

#include "../command_line/option_names.hpp"

// The parameters of the library are where the library has them, with its defaults.
struct Options {
  riprap::RandomAssembly assembly{};
  std::string grading{};  // files of the sample; empty: none
  std::string outlines{};
  riprap::BiaxialTest test{};
  riprap::Rock rock{};
  bool paraview = false;
  bool frames = false;

  // With another one the options that it sets are not to be given.
  std::string preset = "model";

  std::string boundary = "particles";
  std::string integrator = "euler";
  riprap::LocalDamping damping{};
  riprap::MassFloor time_step{};
  riprap::MassFloor time_step_of_others{.fraction = 0.12};  // than the energy-conserving contact

  std::string contact = "energy-conserving";
  riprap::EnergyConservingSpring energy_conserving{};
  riprap::LinearSpringCoulomb linear{};
  riprap::IncrementalSpring incremental{};
  riprap::OverlapAreaSpring area{};
  riprap::SpringDashpot dashpot{};
  riprap::UniformGrid broad_phase{};

  std::string plane = "stress";
  std::string support = "inertia-relief";
  riprap::UniformMesher mesher{};

  std::string breakage = "on";
  std::string criterion = "hoek-brown";
  riprap::HoekBrown hoek_brown{};
  std::string hoek_brown_angle = "equivalent";
  riprap::MohrCoulomb mohr_coulomb{};
  riprap::Griffith griffith{};
  riprap::ModifiedGriffith modified_griffith{};
  riprap::Murrell murrell{};
  riprap::Hobbs hobbs{};
  riprap::Franklin franklin{};
  std::string trigger = "failed-elements";
  riprap::FailedElementRatio failed_elements{};
  riprap::BrazilianStrength brazilian{};
  riprap::HertzianStrength hertzian{};
  riprap::TsounguiStrength tsoungui{};
  std::string strength_scatter = "none";
  riprap::WeibullStrength weibull{};  // `critical` is that of the failed elements
  double strength_diameter = 0.016;   // at which strengths are those of the rock [m]
  std::string line_fit = "xy";        // another one goes with each trigger by the loads
  riprap::StraightCut splitter{};
  unsigned check_every = 1;

  std::string out = "biaxial-out";
  std::string resume{};  // the folder of a run that was stopped; then `out` as well
  unsigned checkpoint_every = 0;
  unsigned threads = 1;
  bool timer = false;

  // Which option sets which member, for errors; and a file that repeats the run with --config.
  command_line::OptionNames names{};
  std::string toml{};

  // Do preset, contact law, integrator, support, boundary, trigger and scatter have their defaults,
  // for which there are programs without choices?
  [[nodiscard]] bool compiled_in() const {
    return preset == "model" && contact == "energy-conserving" && integrator == "euler" &&
           support == "inertia-relief" && boundary == "particles" && !breaks_by_loads() &&
           strength_scatter == "none";
  }
  // Does the trigger need no finite elements? Then the line fit needs none either.
  [[nodiscard]] bool breaks_by_loads() const { return trigger != "failed-elements"; }
};

// The options of a command without the name of the program; throws CLI::ParseError for --help and
// for a command that is wrong.
Options options_from(const std::vector<std::string>& arguments);

// Throws riprap::InvalidInput, in the names of the library, for a value that breaks a rule which no
// simulation is needed to check.
void check_values(const Options& options);

// Reads the same; exits on --help, --version and a command that is wrong.
Options read_options(int argc, char** argv);
