// biaxial: a biaxial test on breakable polygons, with curves and pictures at the end

#include <cstdio>
#include <exception>

#include "options.hpp"

int main(int argc, char** argv) {
  const Options options = read_options(argc, argv);
  try {
    if (!options.breakage)
      run_without_breakage(options);
    else if (options.support == "pinned")
      run_with_pinned_contacts(options);
    else
      run_with_inertia_relief(options);
  } catch (const riprap::InvalidInput& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 1;
  }
}
