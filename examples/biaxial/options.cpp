// SPDX-License-Identifier: BSL-1.0
// Command line of the biaxial example.

#include "options.hpp"

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "../command_line/config_file.hpp"
#include "../command_line/program.hpp"
#include "../command_line/resume.hpp"
#include "option_groups.hpp"

namespace {

using command_line::OptionTable;

// What changes no result.
void add_program(OptionTable& table, Options& o) {
  table.begin_group("Program", false);
  table.add_text("--out", o.out, "folder for the results");
  table.add_text("--resume", o.resume,
                 "go on with the run in this folder, from its last checkpoint, with its options; "
                 "beside it only --strain, --threads, --timer and --checkpoint-every");
  table.add_number("--checkpoint-every", o.checkpoint_every, "checkpoint_every",
                   "steps between checkpoints; 0: only when SIGINT, SIGTERM or SIGUSR1 comes");
  table.add_number("--threads", o.threads, "Threads.count", "that share the work")
      ->check(CLI::Range(1U, 1024U));
  table.add_flag("--timer", o.timer, "print which part of a step takes how much time");
}

// The stiffness that a chord of the mean diameter has does not change with the size.
void adapt_area_spring(const OptionTable& table, Options& o) {
  const double size = o.assembly.mean_diameter / riprap::OverlapAreaSpring{}.largest_chord;
  if (!table.is_given("--area-stiffness")) o.area.area_stiffness /= size * size;
  if (!table.is_given("--largest-chord")) o.area.largest_chord = o.assembly.mean_diameter;
}

// Does a line fit of this name need no finite elements?
bool by_loads(const std::string& line_fit) {
  return line_fit == "loaded-diameter" || line_fit == "mean-stress" ||
         line_fit == "mean-stress-plane";
}

// Names of the policies that a preset sets, for the summary; their options are not to be given.
void apply_preset(OptionTable& table, Options& o) {
  if (o.preset == "model") return;
  table.exclude({"--contact",
                 "--friction",
                 "--normal-stiffness",
                 "--tangential-stiffness",
                 "--boundary",
                 "--integrator",
                 "--time-step-fraction",
                 "--plane",
                 "--support",
                 "--mesh-triangles",
                 "--criterion",
                 "--compressive-strength",
                 "--m-b",
                 "--s",
                 "--a-b",
                 "--hoek-brown-angle",
                 "--trigger",
                 "--ratf",
                 "--particle-strength",
                 "--strength-scatter",
                 "--weibull-modulus",
                 "--weibull-dimension",
                 "--strength-diameter",
                 "--line-fit"},
                "--preset");
  if (o.preset == "recommended") o.line_fit = "mean-tension";
  if (o.preset == "paper") o.support = "pinned";
}

// The line fit that goes with a trigger by the loads, unless one is given.
void choose_line_fit(const OptionTable& table, Options& o) {
  if (table.is_given("--line-fit") || !o.breaks_by_loads()) return;
  o.line_fit = o.trigger == "mean-stress" ? "mean-stress-plane"
               : o.trigger == "tsoungui"  ? "mean-stress"
                                          : "loaded-diameter";
}

// What goes together, and with this build.
void check_combination(const Options& o) {
  if (o.breaks_by_loads() && !by_loads(o.line_fit))
    throw CLI::ValidationError("--line-fit", "'" + o.line_fit +
                                                 "' needs finite elements, which the trigger '" +
                                                 o.trigger + "' does without");
#ifndef _OPENMP
  if (o.threads > 1)
    throw CLI::ValidationError("--threads", "this program was built without OpenMP, which was not "
                                            "found: it has one thread");
#endif
  if (o.timer && !o.compiled_in())
    throw CLI::ValidationError("--timer",
                               "goes with the default preset, boundary, contact law, integrator, "
                               "support, trigger and scatter only");
}

// The options with what reads them.
struct Reader {
  Options options{};
  CLI::App app{
      "Biaxial test on an assembly of random sharp polygons: compaction, relaxation,\n"
      "hydrostatic pressure, shear; curves, pictures and a summary are written to a folder."};
  OptionTable table{app};

  Reader() {
    app.get_formatter()->column_width(42);
    command_line::add_config_option(app);
    add_sample_and_test(table, options);
    add_model(table, options);
    add_program(table, options);
  }

  void parse(const std::vector<std::string>& arguments) {
    const std::vector<std::string> all =
        command_line::with_resumed_options(arguments, {"--strain", "--threads", "--timer"});
    std::vector<const char*> argv{"biaxial"};
    for (const std::string& argument : all) argv.push_back(argument.c_str());
    app.parse(static_cast<int>(argv.size()), argv.data());
    command_line::check_config_option(app);
    table.check_choices();
    apply_preset(table, options);
    choose_line_fit(table, options);
    check_combination(options);
    adapt_area_spring(table, options);
    if (!options.grading.empty())
      table.exclude({"--mean-diameter", "--smallest-diameter", "--largest-diameter"}, "--grading");
    if (!options.outlines.empty())
      table.exclude(
          {"--vertices", "--smallest-axis-ratio", "--largest-axis-ratio", "--angle-jitter"},
          "--outlines");
    if (options.hoek_brown_angle == "tangent")
      options.hoek_brown.angle = riprap::HoekBrown::Angle::tangent;
    options.names = table.names();
    options.toml = table.toml();
  }
};

}  // namespace

Options options_from(const std::vector<std::string>& arguments) {
  Reader reader;
  reader.parse(arguments);
  return reader.options;
}

Options read_options(int argc, char** argv) {
  Reader reader;
  command_line::parse_or_exit(reader.app, [&] { reader.parse({argv + 1, argv + argc}); });
  return reader.options;
}
