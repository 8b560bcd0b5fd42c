// SPDX-License-Identifier: BSL-1.0
// paper: the paper's study: biaxial tests at six pressures with and without breakage, and a report

#include <cstdio>
#include <filesystem>

#include "../command_line/program.hpp"
#include "options.hpp"
#include "report/report.hpp"
#include "runs/run_queue.hpp"
#include "runs/run_unconfined.hpp"
#include "runs/study_design.hpp"

int main(int argc, char** argv) {
  const study::Options options = study::read_options(argc, argv);
  return command_line::run_program({}, [&] {
    const auto outcome = study::make_runs(study::all_runs(options), options.out, options.jobs);
    study::make_unconfined(std::filesystem::path(options.out) / "unconfined");
    write_report(options.out);
    std::printf("%zu runs made, %zu kept; open %s/report.html\n", outcome.finished, outcome.kept,
                options.out.c_str());
    if (options.quick)
      std::printf(
          "This was a quick look at small samples: its numbers are not those of the study.\n");
    for (const std::string& place : outcome.failed)
      std::fprintf(stderr, "failed: see %s/error.txt\n", place.c_str());
    return outcome.failed.empty() ? command_line::finished : command_line::failed;
  });
}
