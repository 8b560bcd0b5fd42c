// SPDX-License-Identifier: BSL-1.0
#include "sample_files.hpp"

#include <filesystem>

#include <riprap/geometry/read_polygons.hpp>
#include <riprap/measurement/sieve_classes.hpp>

Options with_sample_files(Options options) {
  riprap::RandomAssembly& assembly = options.assembly;
  if (!options.grading.empty()) {
    const auto grading = riprap::read_grading(std::filesystem::path(options.grading));
    assembly.diameters = riprap::sieve_class_diameters(grading, assembly.count);
    double sum = 0;
    for (const double d : assembly.diameters) sum += d;
    assembly.mean_diameter = sum / assembly.count;  // for the summary
  }
  if (!options.outlines.empty())
    assembly.outlines = riprap::read_polygons(std::filesystem::path(options.outlines));
  return options;
}
