// SPDX-License-Identifier: BSL-1.0
// replay: packs the frames of a run into one HTML page that plays them, needing no network

#include <cstdio>
#include <filesystem>

#include <riprap/core/errors.hpp>
#include <riprap/output/file.hpp>

#include "../command_line/program.hpp"
#include "options.hpp"
#include "page.hpp"
#include "recorded_run.hpp"

int main(int argc, char** argv) {
  const replay::Options options = replay::read_options(argc, argv);
  return command_line::run_program(options.names, [&] {
    if (!std::filesystem::exists(options.frames_file()))
      throw riprap::InvalidInput(options.frames_file() +
                                 " is not there: only a run with frames (examples/run biaxial "
                                 "--frames) can be replayed");
    const replay::RecordedRun run = replay::read_run(options.frames_file(), options.every);
    const std::string page = replay::page_of(run, options.title());
    riprap::write_file(options.out_file(), page);
    std::printf("%zu frames, %zu particles, %zu breaks: %.1f MB in %s\n", run.frames.size(),
                run.particles.size(), run.breaks.size(), 1e-6 * static_cast<double>(page.size()),
                options.out_file().c_str());
    return command_line::finished;
  });
}
