// SPDX-License-Identifier: BSL-1.0
// unconfined: rock specimens between platens: Rat at failure and what moves it, to calibrate RatF

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include "../command_line/option_table.hpp"
#include "../command_line/program.hpp"
#include "files.hpp"

namespace {

using unconfined::Options;

void add_friction(command_line::OptionTable& table, Options& o) {
  const std::string option = "--friction";
  table.add_text(
      option, "of the platens [-], a number above 0 or rough",
      [option, &o](const std::string& text) {
        const auto number = command_line::number_from<double>(text);
        if (!number && text != "rough")
          throw CLI::ValidationError(option, "'" + text + "' is neither a number nor rough");
        o.friction = number.value_or(std::numeric_limits<double>::infinity());
      },
      [&o] { return std::isinf(o.friction) ? "rough" : riprap::to_text(o.friction); },
      {"UnconfinedCompression.friction"});
}

void add_options(command_line::OptionTable& table, Options& o) {
  table.begin_group("Options");
  table.add_number("--poisson", o.poisson, "Rock.poisson", "Poisson's ratio [-]");
  table.add_number("--m-b", o.m_b, "HoekBrown.m_b", "Hoek-Brown constant of the intact rock [-]");
  table.add_number("--strength", o.strength, "HoekBrown.compressive_strength",
                   "uniaxial compressive strength [Pa]");
  table.add_number("--young", o.young, "Rock.young", "Young's modulus [Pa]");
  table.add_number("--width", o.width, "UnconfinedCompression.width", "of the specimen [m]");
  table.add_number("--aspect", o.aspect, "", "height over width [-]");
  add_friction(table, o);
  table.add_number("--load", o.load, "UnconfinedCompression.load",
                   "mean platen stress at failure over the strength [-]");
  table.add_number("--mesh-triangles", o.triangles, "UniformMesher.triangles",
                   "wanted in the mesh [-]");
  table.add_choice("--criterion", o.criterion, {"hoek-brown", "mohr-coulomb"},
                   "failure of an element");
  table.add_choice("--plane", o.plane, {"stress", "strain"}, "plane stress or plane strain");
  table.add_text("--out", o.out, "folder for unconfined.json and the pictures (SVG)");
}

void print(const unconfined::Study& s) {
  const riprap::UnconfinedResult& r = s.specimen.result;
  std::printf(
      "Rat %.3f at %g times the strength: %zu of %zu elements, %zu in shear, %zu in tension\n",
      r.ratio(), s.options.load, r.failures.failed, r.failures.elements, r.shear, r.tensile);
  std::printf("which is RatF for this rock in this specimen; the paper has 0.32 to 0.39, 0.34 on "
              "average, and takes 0.4\n");
  std::printf("Rat reaches 0.4 at %.3f times the strength\n", s.load_at_0_4);
  const auto line = [](const unconfined::Sweep& sweep, const std::string& with = "") {
    const auto& first = sweep.points.front();
    const auto& last = sweep.points.back();
    std::printf("  %-32s%-9s Rat %.3f at %-8g %.3f at %-8g lowest %.3f, highest %.3f\n",
                sweep.parameter.c_str(), with.c_str(), first.y(), first.x(), last.y(), last.x(),
                sweep.lowest(), sweep.highest());
  };
  std::printf("what moves it:\n");
  for (const auto& p : s.poisson) line(p.sweep, "m_b " + riprap::to_text(p.m_b));
  for (const auto* sweep : {&s.young, &s.strength}) line(*sweep);
  for (const auto& sweep : s.others) line(sweep);
  for (const unconfined::Claim& claim : unconfined::claims(s))
    std::printf("%s: %s\n", claim.name.c_str(), claim.verdict.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{
      "Unconfined compression of a rectangular specimen in finite elements, up to the uniaxial\n"
      "strength: the share of failed elements (Rat) at failure, which is RatF for that rock, and\n"
      "Rat against each parameter. Numbers and pictures are written to a folder."};
  app.get_formatter()->column_width(42);
  command_line::OptionTable table(app);
  add_options(table, options);
  command_line::parse_or_exit(app, [&] { app.parse(argc, argv); });
  return command_line::run_program(table.names(), [&] {
    const unconfined::Study study = unconfined::unconfined_study(options);
    print(study);
    unconfined::write_files(study, options.out);
    std::printf("numbers and pictures in %s\n", options.out.c_str());
    return command_line::finished;
  });
}
