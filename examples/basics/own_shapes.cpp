// SPDX-License-Identifier: BSL-1.0
// own_shapes: a sample of outlines and a grading from files; what it passes beside the grading
// Reads shapes.csv (or a .wkt) and grading.csv, which are beside this file, or the two files that
// it is given: examples/run own_shapes SHAPES GRADING

#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>

#include <riprap/geometry/read_polygons.hpp>
#include <riprap/measurement/read_grading.hpp>
#include <riprap/output/assembly_picture.hpp>
#include <riprap/riprap.hpp>
using namespace riprap;

int main(int argc, char** argv) try {
  const std::filesystem::path here = std::filesystem::path(__FILE__).parent_path();
  const auto outlines = read_polygons(argc > 1 ? argv[1] : here / "shapes.csv");
  const Grading wanted = read_grading(argc > 2 ? argv[2] : here / "grading.csv");

  const unsigned count = 400;
  const RandomAssembly options{.count = count,
                               .seed = 1,
                               .diameters = graded_diameters(wanted, count),
                               .outlines = outlines};
  const Simulation sim{Model{}.boundary(RigidPlatens{}), random_platen_assembly(options), Rock{}};
  const Grading made = grading(sim.particles());

  double area = 0;
  for (BodyIndex i = 0; i < sim.particles().size(); ++i)
    if (sim.particles().body(i).is_free()) area += sim.particles().shape(i).area;
  const double largest = std::acos(-1.0) / 4 * made.largest() * made.largest();
  // A sample has whole particles: its curve departs by the mass of the largest one.
  const double tolerance = 2 * largest / area;
  std::printf("%u particles of %zu outlines\n   size   passing in the sample and in the file\n",
              count, outlines.size());
  bool close = true;
  for (const GradingPoint& sieve : wanted.points()) {
    const double passing = made.passing(sieve.size);
    std::printf("%4.0f mm  %6.3f %6.3f\n", 1e3 * sieve.size, passing, sieve.passing);
    close = close && std::abs(passing - sieve.passing) <= tolerance;
  }
  assembly_picture(sim.particles(), {}, "Outlines and grading from files").save("own_shapes.svg");
  std::printf("picture in own_shapes.svg\n");
  return close ? 0 : 1;
} catch (const std::exception& error) {  // InvalidInput names file, line, value and rule
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
