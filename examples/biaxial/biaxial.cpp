// SPDX-License-Identifier: BSL-1.0
// biaxial: a biaxial test on breakable polygons, with curves and pictures at the end

#include <cstdio>
#include <exception>

#include "options.hpp"

int main(int argc, char** argv) {
  const Options options = read_options(argc, argv);
  try {
    if (options.boundary == "platens")
      run_choices_platens(options);
    else if (options.boundary == "periodic")
      run_choices_periodic(options);
    else if (!options.compiled_in())
      run_choices_particles(options);
    else if (options.timer)
      run_timed(options);
    else if (options.breakage)
      run_with_inertia_relief(options);
    else
      run_without_breakage(options);
  } catch (const riprap::InvalidInput& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 1;
  }
}
