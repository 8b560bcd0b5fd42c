// SPDX-License-Identifier: BSL-1.0
// Command line of the study.

#include "options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <thread>

namespace study {

Options read_options(int argc, char** argv) {
  Options o;
  o.jobs = std::max(1U, std::thread::hardware_concurrency());
  CLI::App app{
      "The paper's study: biaxial tests at 0.5 to 14 MPa without breakage (nb), with breakage "
      "(wb)\n"
      "and with breakage of particles pinned at two contacts (pinned), side by side; then a "
      "report.\n"
      "Runs that are finished are kept, so that an interrupted study goes on where it was."};
  app.get_formatter()->column_width(30);
  app.option_defaults()->always_capture_default();
  app.add_option("--samples", o.samples, "samples, seeds 1, 2, ..., of each series")
      ->check(CLI::Range(1, 1000));
  app.add_option("--jobs", o.jobs, "runs side by side; changes no result")
      ->check(CLI::Range(1, 1024));
  app.add_flag("--quick", o.quick,
               "a glance: 150 particles, three pressures, one sample; not a study");
  app.add_option("--out", o.out, "folder for the results [paper, or paper-quick with --quick]")
      ->capture_default_str()
      ->default_str("");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::exit(app.exit(error));
  }
  if (o.out.empty()) o.out = o.quick ? "paper-quick" : "paper";
  if (o.quick && app.count("--samples") == 0) o.samples = 1;
  return o;
}

}  // namespace study
