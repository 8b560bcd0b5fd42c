// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <vector>

#include <riprap/geometry/read_outlines.hpp>
#include <riprap/geometry/shape_measures.hpp>
#include <riprap/geometry/voronoi_cells.hpp>
#include <riprap/measurement/sieve_classes.hpp>
#include <riprap/particle/random_stones.hpp>
#include <riprap/riprap.hpp>
using namespace riprap;

int main() {
  const std::filesystem::path here = std::filesystem::path(__FILE__).parent_path();

  // Outlines in millimetres, convex or concave; each becomes a few convex parts.
  const std::vector<Outline> outlines = read_outlines(here / "stones.wkt", 1.0_mm);
  const std::vector<Stone> library = stones_of(outlines);
  std::printf("stone parts elongation circularity convexity\n");
  for (std::size_t k = 0; k < library.size(); ++k)
    std::printf("%5zu %5zu %10.2f %11.2f %9.2f\n", k, library[k].cells.size(),
                elongation(outlines[k].ring()), circularity(outlines[k].ring()),
                convexity(outlines[k].ring()));

  // Sizes by the sieve curve, class by class; places and rotations at random, between four walls.
  const Grading wanted = read_grading(here / "sieve_curve.csv");
  const RandomAssembly options{
      .count = 300, .seed = 1, .diameters = sieve_class_diameters(wanted, 300)};
  const StoneAssembly sample = random_platen_stones(options, library);

  // The curve of the sample, of whole stones: their cells are particles of one cluster each.
  std::vector<SizeFraction> fractions;
  for (const std::vector<std::size_t>& cluster : sample.clusters()) {
    double area = 0;
    for (const std::size_t i : cluster)
      area += polygon_area(sample.assembly.particles[i].polygon.ring());
    fractions.push_back({equivalent_diameter(area), area});
  }
  const Grading made = Grading::of_fractions(fractions);
  double worst = 0;
  std::printf("%u stones, %zu particles with the walls\n", sample.count(), sample.stone.size());
  for (const GradingPoint& sieve : wanted.points()) {
    const double passing = made.passing(sieve.size * (1 + 1e-9));
    std::printf("%4.0f mm %6.3f passes, %6.3f in the file\n", 1e3 * sieve.size, passing,
                sieve.passing);
    worst = std::max(worst, std::abs(passing - sieve.passing));
  }

  // A convex stone as forty cells that could be tied together, by bonds that break.
  const ConvexPolygon stone = library[0].cells[0];
  const std::vector<ConvexPolygon> cells = voronoi_cells(stone, {.count = 40, .seed = 1});
  double filled = 0;
  for (const ConvexPolygon& cell : cells) filled += polygon_area(cell.ring());
  std::printf("%zu cells fill the stone to a share of %.0e\n", cells.size(),
              std::abs(filled / polygon_area(stone.ring()) - 1));
  return worst < 1e-9 ? 0 : 1;
}
