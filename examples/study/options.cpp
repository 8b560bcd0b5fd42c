// SPDX-License-Identifier: BSL-1.0
#include "options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <thread>

#include <riprap/core/errors.hpp>

#include "../command_line/option_table.hpp"
#include "../command_line/program.hpp"

namespace run_study {

namespace fs = std::filesystem;

namespace {

// What stands beside this program.
fs::path program_beside(const char* called_as) {
  std::error_code error;
  fs::path self = fs::read_symlink("/proc/self/exe", error);
  if (error) self = called_as;
  return self.parent_path() / "example_biaxial";
}

void add_making(command_line::OptionTable& table, Making& making) {
  table.begin_group("Making the runs");
  table.add_number("--jobs", making.jobs, "", "runs at a time; changes no result")
      ->check(CLI::Range(1U, 1024U));
  table.add_number("--threads", making.threads, "", "of a run; changes no result")
      ->check(CLI::Range(1U, 1024U));
  table.add_number("--checkpoint-every", making.checkpoint_every, "",
                   "steps between checkpoints of a run; 0: none, and what was stopped begins anew");
  table.add_flag("--retry", making.retry, "make runs again that have failed");
  table.add_flag("--take-over", making.take_over,
                 "make runs that another machine has left locked; only if nothing runs there");
}

}  // namespace

Options read_options(int argc, char** argv) {
  Options o;
  CLI::App app{
      "Biaxial tests of a table, each in a folder of its own; what is finished is kept, and\n"
      "what is not is made. docs/study.md says how a table is written.\n"
      "Exit code 0: all runs are finished; 1: some have failed; 2: the command or the table\n"
      "is wrong, and nothing was made; 75: stopped, or others are at work: call it again."};
  app.get_formatter()->column_width(30);
  o.making.jobs = std::max(1U, std::thread::hardware_concurrency());
  std::string shard;
  std::string out;
  std::string program = program_beside(argv[0]).string();
  app.add_option("table", o.table, "file of the table, or one of those that come with the example")
      ->required();
  command_line::OptionTable table(app);
  table.begin_group("Options");
  table.add_text("--out", out, "folder of the study [name of the table]");
  table.add_text("--shard", shard, "I/N: every N-th run of the table from the I-th on");
  table.add_number("--seeds", o.seeds, "", "of each row at most, the first ones; 0: all")
      ->check(CLI::Range(0U, 100000U));
  table.add_flag("--list", o.list, "print the runs and how far they are; make none");
  add_making(table, o.making);
  table.add_text("--program", program, "that makes a run [example_biaxial beside this program]");
  table.begin_group("Results");
  table.add_flag("--summary", o.summary, "of the runs that are there; make none");
  table.add_text("--against", o.against,
                 "OPTION=VALUE or row=NAME: differences to these runs, by pairs of a seed");
  app.add_option("--plot", o.plots, "Y:X or Y:X:GROUP, a result over an option; several times")
      ->type_name("TEXT")
      ->group("Results");
  app.add_option("--where", o.where, "OPTION=VALUE that is shown in plots; several times")
      ->type_name("TEXT")
      ->group("Results");
  table.add_flag("--log-x", o.log_x, "plots have a logarithmic axis of x");
  command_line::parse_or_exit(app, [&] { app.parse(argc, argv); });
  if (out.empty()) out = fs::path(o.table).stem().string();
  o.making.folder = out;
  o.making.program = program;
  try {
    if (!shard.empty()) o.shard = shard_from(shard);
  } catch (const riprap::InvalidInput& error) {
    std::exit((std::fprintf(stderr, "%s\n", error.what()), command_line::wrong_command));
  }
  return o;
}

std::string table_path(const std::string& table) {
  if (fs::exists(table)) return table;
  const fs::path shipped = fs::path(RIPRAP_STUDY_TABLES) / (table + ".toml");
  if (fs::exists(shipped)) return shipped.string();
  std::string known;
  for (const auto& entry : fs::directory_iterator(RIPRAP_STUDY_TABLES))
    known += (known.empty() ? "" : ", ") + entry.path().stem().string();
  throw riprap::InvalidInput("there is no table '" + table + "'; those of the example are " +
                             known);
}

}  // namespace run_study
