// SPDX-License-Identifier: BSL-1.0
#include "options.hpp"

#include <riprap/core/errors.hpp>
#include <riprap/measurement/dimensionless.hpp>

#include "../command_line/number.hpp"

namespace shear_tests {

namespace {

// "1e6,4e6"
std::vector<double> read_stresses(const std::string& option, const std::string& text) {
  std::vector<double> stresses;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string part = text.substr(begin, end - begin);
    const auto number = command_line::number_from<double>(part);
    if (!number)
      throw CLI::ValidationError(option,
                                 "'" + part + "' is not a number, in a list such as 1e6,4e6");
    stresses.push_back(*number);
    begin = end + 1;
  }
  return stresses;
}

std::string stresses_text(const std::vector<double>& stresses) {
  std::string text;
  for (const double s : stresses) text += (text.empty() ? "" : ",") + command_line::text_of(s);
  return text;
}

}  // namespace

double Options::rate(double normal_stress) const {
  return inertial_number /
         riprap::inertial_number(1, assembly.mean_diameter, rock.density, normal_stress);
}

void Options::validate() const {
  riprap::require(samples > 0, "--samples", samples, "must be above 0");
  for (const double s : normal_stresses) riprap::require_positive("--normal-stresses", s);
  riprap::require_positive("--shear", shear);
  riprap::require_positive("--inertial-number", inertial_number);
  assembly.validate();
  rock.validate();
  contact.validate();
  damping.validate();
  criterion.validate();
}

void add_options(command_line::OptionTable& table, Options& o, const std::string& shear) {
  const std::string stresses = "--normal-stresses";
  table.begin_group("Sample");
  table.add_number("--particles", o.assembly.count, "RandomAssembly.count", "in a sample");
  table.add_number("--seed", o.assembly.seed, "RandomAssembly.seed",
                   "of the first sample; same seed, same bytes");
  table.add_number("--samples", o.samples, "", "at each normal stress");
  table.add_number("--friction", o.contact.friction, "EnergyConservingSpring.friction",
                   "of contacts, those with walls included [-]");
  table.add_number("--strength", o.criterion.compressive_strength, "HoekBrown.compressive_strength",
                   "uniaxial compressive strength [Pa]");
  table.add_choice("--breakage", o.breakage, {"on", "off"}, "whether particles break");
  table.begin_group("Test");
  table.add_text(
      stresses, "one test at each [Pa]",
      [&o, stresses](const std::string& text) {
        o.normal_stresses = read_stresses(stresses, text);
      },
      [&o] { return stresses_text(o.normal_stresses); });
  table.add_number("--shear", o.shear, "", shear);
  table.add_number("--inertial-number", o.inertial_number, "", "of shear, sets its rate [-]");
  table.add_number("--damping", o.damping.coefficient, "LocalDamping.coefficient",
                   "local, in shear; 0.7 before it [-]");
  table.add_flag("--quick", o.quick, "a small sample and little shear, as a trial");
  table.add_text("--out", o.out, "folder for the tables, summary.json and the pictures (SVG)");
}

std::string stress_text(double pascals) { return riprap::to_text(1e-6 * pascals) + " MPa"; }

}  // namespace shear_tests
