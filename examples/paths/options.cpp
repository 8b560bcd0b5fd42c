// SPDX-License-Identifier: BSL-1.0
#include "options.hpp"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "../command_line/config_file.hpp"
#include "../command_line/option_table.hpp"
#include "../command_line/program.hpp"
#include "../command_line/resume.hpp"

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
  command_line::add_config_option(app);
  app.add_option("TEST,--test", o.test,
                 "which test, or a file NAME.toml; without it they are listed")
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
  table.begin_group("Program", false);
  table.add_text("--out", o.out, "folder for the results");
  table.add_text("--resume", o.resume,
                 "go on with the last command that wrote into this folder, from its checkpoints, "
                 "with its options; beside it only --checkpoint-every");
  table.add_number("--checkpoint-every", o.checkpoint_every, "checkpoint_every",
                   "steps between checkpoints; 0: only when SIGINT, SIGTERM or SIGUSR1 comes");
  command_line::parse_or_exit(app, [&] {
    std::vector<const char*> all{argv[0]};
    const auto arguments = command_line::with_resumed_options({argv + 1, argv + argc}, {});
    for (const std::string& argument : arguments) all.push_back(argument.c_str());
    app.parse(static_cast<int>(all.size()), all.data());
    command_line::check_config_option(app);
    apply_quick(table, o);
  });
  // Strings of JSON are strings of TOML.
  o.toml = table.toml() + "test = " + nlohmann::json(o.test).dump() + "\n";
  o.names = table.names();
  return o;
}

}  // namespace paths
