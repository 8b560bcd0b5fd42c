// SPDX-License-Identifier: BSL-1.0
// single_particle: one polygon under forces: mesh, safety factors, crack lines, pieces in a picture

#include <cstdio>
#include <exception>

#include "analysis.hpp"
#include "options.hpp"
#include "picture.hpp"
#include "report.hpp"

int main(int argc, char** argv) {
  try {
    const Options options = read_options(argc, argv);
    const Analysis analysis = analyse(chosen_case(options));
    print_report(analysis);
    picture(analysis).save(options.out);
    std::printf("picture in %s\n", options.out.c_str());
  } catch (const riprap::InvalidInput& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 1;
  }
}
