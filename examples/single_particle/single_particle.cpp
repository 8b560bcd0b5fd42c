// SPDX-License-Identifier: BSL-1.0
// single_particle: one polygon under forces: mesh, safety factors, crack lines, pieces in a picture

#include <cstdio>

#include "../command_line/program.hpp"
#include "analysis.hpp"
#include "options.hpp"
#include "picture.hpp"
#include "report.hpp"

int main(int argc, char** argv) {
  const auto options = single_particle::read_options(argc, argv);
  return command_line::run_program(options.names, [&] {
    const Analysis analysis = analyse(chosen_case(options));
    print_report(analysis);
    picture(analysis).save(options.out);
    std::printf("picture in %s\n", options.out.c_str());
    return command_line::finished;
  });
}
