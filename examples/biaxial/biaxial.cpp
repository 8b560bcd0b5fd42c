// SPDX-License-Identifier: BSL-1.0
// biaxial: a biaxial test on breakable polygons, with curves and pictures at the end

#include <cstdio>

#include "../command_line/program.hpp"
#include "options.hpp"
#include "result_files.hpp"
#include "runs.hpp"
#include "sample_files.hpp"

namespace {

Outcome run_chosen(const Options& options) {
  if (options.preset == "recommended") return run_recommended(options);
  if (options.preset == "paper") return run_paper(options);
  if (options.breaks_by_loads()) {
    if (options.boundary == "platens") return run_loads_platens(options);
    if (options.boundary == "periodic") return run_loads_periodic(options);
    return run_loads_particles(options);
  }
  if (options.boundary == "platens") return run_choices_platens(options);
  if (options.boundary == "periodic") return run_choices_periodic(options);
  if (!options.compiled_in()) return run_choices_particles(options);
  if (options.timer) return run_timed(options);
  if (options.breakage == "on") return run_with_inertia_relief(options);
  return run_without_breakage(options);
}

}  // namespace

int main(int argc, char** argv) {
  const Options options = read_options(argc, argv);
  if (const std::optional<double> reached =
          options.resume.empty() ? std::nullopt : finished_strain(options.resume)) {
    std::printf("the run in %s is finished, at an axial strain of %g\n", options.resume.c_str(),
                *reached);
    if (options.test.axial_strain == *reached) return command_line::finished;
    std::fprintf(stderr,
                 "error: --strain = %g: a finished run has no checkpoint to go on from; begin one "
                 "with this strain\n",
                 options.test.axial_strain);
    return command_line::wrong_command;
  }
  return command_line::run_program(options.names, [&] {
    return run_chosen(with_sample_files(options)) == Outcome::finished ? command_line::finished
                                                                       : command_line::failed;
  });
}
