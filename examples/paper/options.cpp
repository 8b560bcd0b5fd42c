// SPDX-License-Identifier: BSL-1.0
// Command line of the study.

#include "options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <thread>

#include "../command_line/option_table.hpp"
#include "../command_line/program.hpp"

namespace study {

Options read_options(int argc, char** argv) {
  Options o;
  o.jobs = std::max(1U, std::thread::hardware_concurrency());
  CLI::App app{
      "The paper's study: biaxial tests at 0.5 to 14 MPa without breakage (nb) and with "
      "breakage\n"
      "(wb), rows that change one thing at a time, and a report.\n"
      "Runs that are finished are kept, so that an interrupted study goes on where it was."};
  app.get_formatter()->column_width(30);
  command_line::OptionTable table(app);
  table.begin_group("Options");
  table
      .add_number("--samples", o.samples, "",
                  "samples, seeds 1, 2, ..., of each series; two more at 2 and 4 MPa")
      ->check(CLI::Range(1, 1000));
  table.add_number("--jobs", o.jobs, "", "runs side by side; changes no result")
      ->check(CLI::Range(1, 1024));
  table.add_flag("--quick", o.quick,
                 "a glance: 150 particles, three pressures, one sample; not a study");
  table.add_text("--out", o.out, "folder for the results [paper, or paper-quick with --quick]");
  command_line::parse_or_exit(app, [&] { app.parse(argc, argv); });
  if (o.out.empty()) o.out = o.quick ? "paper-quick" : "paper";
  if (o.quick && !table.is_given("--samples")) o.samples = 1;
  return o;
}

}  // namespace study
