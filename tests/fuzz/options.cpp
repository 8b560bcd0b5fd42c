// SPDX-License-Identifier: BSL-1.0
// Any command of the biaxial example, any file of parameters and any polygon and force of the
// example of a single particle are taken, or refused with an error that names the option.

#include <biaxial/options.hpp>
#include <command_line/config_file.hpp>
#include <single_particle/options.hpp>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <unistd.h>
#include <vector>

#include <riprap/core/errors.hpp>

#include "check.hpp"
#include "targets.hpp"

namespace riprap::fuzz {

namespace {

/// A file that is gone at the end of the program.
struct Scratch {
  std::string path = "/tmp/riprap_fuzz_" + std::to_string(getpid());
  ~Scratch() { unlink(path.c_str()); }
};

::Options options_of_file(const std::string& text) {
  static const Scratch scratch;
  std::ofstream(scratch.path, std::ios::binary | std::ios::trunc) << text;
  return options_from({"--config", scratch.path});
}

/// The file of parameters that options write gives the same options.
void check_round_trip(const ::Options& options) {
  const ::Options again = options_of_file(options.toml);
  check(again.toml == options.toml, "options that are written read the same");
  check(again.assembly.count == options.assembly.count &&
            again.assembly.seed == options.assembly.seed &&
            again.test.confining_pressure == options.test.confining_pressure &&
            again.rock.young == options.rock.young && again.criterion == options.criterion &&
            again.splitter.minimum_area == options.splitter.minimum_area,
        "parameters that are written read the same");
  for (const double value :
       {options.test.confining_pressure, options.test.axial_strain, options.rock.young,
        options.rock.poisson, options.linear.friction, options.hoek_brown.m_b,
        options.failed_elements.critical, options.splitter.maximum_aspect})
    check(std::isfinite(value), "a number of an option is finite", {value});
}

/// Lines; none of them names another file to read.
std::vector<std::string> arguments_from(const std::string& text) {
  std::vector<std::string> arguments;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    // A command has no zero bytes.
    if (!line.starts_with("--config")) arguments.emplace_back(line.c_str());
  return arguments;
}

void check_command(const std::string& text) {
  check_round_trip(options_from(arguments_from(text)));
}

void check_file(const std::string& text) {
  if (text.find("config") == std::string::npos) check_round_trip(options_of_file(text));
}

void check_case(const std::string& text) {
  single_particle::Options options;
  std::istringstream lines(text);
  std::getline(lines, options.polygon);
  for (std::string line; std::getline(lines, line);) options.forces.push_back(line);
  const auto chosen = single_particle::chosen_case(options);
  for (const auto& force : chosen.forces)
    check(std::isfinite(force.at.x() + force.at.y()) && std::isfinite(force.force.x()) &&
              std::isfinite(force.force.y()),
          "forces are finite");
}

}  // namespace

void options(Bytes bytes) {
  Input input(bytes);
  const unsigned kind = input.below(3);
  const std::string text = input.text();
  try {
    if (kind == 0) check_command(text);
    if (kind == 1) check_file(text);
    if (kind == 2) check_case(text);
  } catch (const CLI::ParseError& error) {
    check(error.get_exit_code() == 0 || !std::string_view(error.what()).empty(),
          "an error says what is wrong");
  } catch (const InvalidInput&) {
  }
}

}  // namespace riprap::fuzz
