// SPDX-License-Identifier: BSL-1.0
#include "options.hpp"

#include <CLI/CLI.hpp>

#include "../command_line/option_table.hpp"
#include "../command_line/program.hpp"

namespace paths {

namespace {

void apply_quick(const command_line::OptionTable& table, Options& o) {
  if (!o.quick) return;
  if (!table.is_given("--particles")) o.particles = 100;
  if (!table.is_given("--samples")) o.samples = 1;
}

}  // namespace

Options read_options(int argc, char** argv, const std::vector<std::string>& tests) {
  Options o;
  CLI::App app{
      "A test on small samples of random polygons that break, along one of the ready-made\n"
      "loading paths or the one that a file describes (docs/paths.md); curves, pictures\n"
      "and what was found are written to OUT/TEST, or to OUT/file_NAME for NAME.toml."};
  app.get_formatter()->column_width(42);
  std::vector<std::string> values = tests;
  values.push_back("all");
  app.add_option("TEST", o.test, "which test, or a file NAME.toml; without it they are listed")
      ->check([known = CLI::IsMember(values)](const std::string& text) {
        return text.ends_with(".toml") ? std::string() : known(text);
      });
  command_line::OptionTable table(app);
  table.begin_group("Options");
  table.add_number("--particles", o.particles, "RandomAssembly.count", "of a sample");
  table.add_number("--samples", o.samples, "samples", "of the seeds SEED, SEED + 1, ...")
      ->check(CLI::Range(1U, 1000U));
  table.add_number("--seed", o.seed, "RandomAssembly.seed", "of the first sample");
  table.add_flag("--quick", o.quick,
                 "one sample of 100 particles, and a shorter ready-made path, as a trial");
  table.add_text("--out", o.out, "folder for the results");
  command_line::parse_or_exit(app, [&] {
    app.parse(argc, argv);
    apply_quick(table, o);
  });
  o.names = table.names();
  return o;
}

}  // namespace paths
