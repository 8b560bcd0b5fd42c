// SPDX-License-Identifier: BSL-1.0
// shapes: cells that fill a polygon, stones from a file, samples of three elongations; their
// measures Each sample is made, measured, sheared with breakage, and measured again.

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <riprap/geometry/convex_parts.hpp>
#include <riprap/geometry/read_outlines.hpp>
#include <riprap/geometry/shape_measures.hpp>
#include <riprap/geometry/voronoi_cells.hpp>
#include <riprap/output/file.hpp>
#include <riprap/riprap.hpp>
#include <riprap/stress/mesher/triangle_cells.hpp>

#include "../command_line/option_table.hpp"
#include "../command_line/program.hpp"
#include "panels.hpp"

namespace {

using namespace riprap;
namespace fs = std::filesystem;

struct Options {
  unsigned particles = 300;
  std::uint64_t seed = 1;
  double pressure = 8e6;
  double strain = 0.1;
  double spread = 0.2;
  std::string outlines =
      (fs::path(__FILE__).parent_path() / "../../docs/examples/stones.wkt").string();
  double unit = 1e-3;
  std::string out = "shapes";
  bool quick = false;
};

/// Mean and standard deviation.
struct Spread {
  double mean = 0;
  double deviation = 0;
};

/// Measures of all free particles.
struct Measures {
  std::size_t particles = 0;
  Spread elongation, box_elongation, angularity, sphericity, circularity;

  explicit Measures(const std::vector<ConvexPolygon>& polygons) : particles(polygons.size()) {
    const auto spread = [&](auto&& measure) {
      double sum = 0;
      double squares = 0;
      for (const ConvexPolygon& p : polygons) {
        const double value = measure(p);
        sum += value;
        squares += value * value;
      }
      const auto n = static_cast<double>(polygons.size());
      return Spread{sum / n, std::sqrt(std::max(0.0, squares / n - sum * sum / (n * n)))};
    };
    elongation = spread([](const ConvexPolygon& p) { return moment_elongation(p.ring()); });
    box_elongation = spread([](const ConvexPolygon& p) { return riprap::elongation(p.ring()); });
    angularity = spread([](const ConvexPolygon& p) { return riprap::angularity(p); });
    sphericity = spread([](const ConvexPolygon& p) { return riprap::sphericity(p); });
    circularity = spread([](const ConvexPolygon& p) { return riprap::circularity(p.ring()); });
  }
};

std::vector<ConvexPolygon> free_polygons(const Particles& particles) {
  std::vector<ConvexPolygon> out;
  for (BodyIndex i = 0; i < particles.size(); ++i)
    if (particles.body(i).is_free()) {
      const Ring ring = particles.ring(i);
      out.emplace_back(std::vector<Vec2>(ring.begin(), ring.end()));
    }
  return out;
}

void print_row(double asked, const char* state, const Measures& m) {
  std::printf("%5.2f  %-7s %5zu    %5.3f +- %5.3f     %5.3f     %5.3f       %5.3f       %5.3f\n",
              asked, state, m.particles, m.elongation.mean, m.elongation.deviation,
              m.box_elongation.mean, m.angularity.mean, m.sphericity.mean, m.circularity.mean);
}

/// A sample of one mean elongation, before and after it is sheared.
struct Sample {
  std::vector<ConvexPolygon> before, after;
};

Sample sheared_sample(const Options& o, const Distribution& elongation) {
  const RandomAssembly assembly{.count = o.particles,
                                .seed = o.seed,
                                .prescribed_shape = PrescribedShape{.elongation = elongation}};
  Simulation sim{Model{}.boundary(PeriodicCell{}), random_periodic_assembly(assembly), Rock{}};
  Sample sample{.before = free_polygons(sim.particles()), .after = {}};
  BiaxialTest{.confining_pressure = o.pressure, .axial_strain = o.strain}.run(sim);
  sample.after = free_polygons(sim.particles());
  return sample;
}

/// True where the mean elongation of every sample is the one asked for, to four standard errors.
bool samples(const Options& o) {
  std::printf("asked  state  number    elongation          of box    angularity  sphericity  "
              "circularity\n");
  std::vector<ShapePanel> panels;
  bool met = true;
  for (const double mean : {1.15, 1.6, 2.4}) {
    const Distribution wanted = Distribution::uniform(mean - o.spread / 2, mean + o.spread / 2);
    const Sample sample = sheared_sample(o, wanted);
    const Measures before(sample.before);
    print_row(mean, "made", before);
    print_row(mean, "sheared", Measures(sample.after));
    const double error = wanted.standard_deviation() / std::sqrt(before.particles);
    met = met && std::abs(before.elongation.mean - mean) <= 4 * error;
    char title[80];
    std::snprintf(title, sizeof title, "Elongation %.2f, %.0f %% strain", mean, 100 * o.strain);
    panels.push_back({title, sample.after});
  }
  shape_panels(panels, 3, true).save(fs::path(o.out) / "elongations.svg");
  return met;
}

/// True where the areas of the cells add up.
bool cells(const Options& o) {
  Random random(o.seed);
  const ConvexPolygon polygon =
      random_polygon({.fewest_vertices = 6, .most_vertices = 6}, 0.04, random);
  std::vector<ShapePanel> panels;
  double worst = 0;
  const auto add = [&](const std::string& title, std::vector<ConvexPolygon> pieces, double area) {
    double sum = 0;
    for (const ConvexPolygon& piece : pieces) sum += polygon_area(piece.ring());
    worst = std::max(worst, std::abs(sum / area - 1));
    panels.push_back({title, std::move(pieces)});
  };
  const double area = polygon_area(polygon.ring());
  add("80 Voronoi cells, not relaxed",
      voronoi_cells(polygon, {.count = 80, .relaxations = 0, .seed = o.seed}), area);
  add("relaxed 10 times", voronoi_cells(polygon, {.count = 80, .relaxations = 10, .seed = o.seed}),
      area);
  add("triangles of 5 mm", triangle_cells(polygon, 0.005), area);
  const Outline concave({{0, 0},
                         {30, -4},
                         {44, 6},
                         {33, 14},
                         {40, 27},
                         {24, 22},
                         {15, 34},
                         {12, 20},
                         {-6, 22},
                         {4, 11}});
  add("convex parts of an outline", convex_parts(concave), polygon_area(concave.ring()));
  std::printf("cells fill their polygons to a share of %.0e\n", worst);
  shape_panels(panels, 4, false).save(fs::path(o.out) / "cells.svg");
  return worst < 1e-12;
}

void stones(const Options& o) {
  std::vector<ShapePanel> panels;
  std::printf("stone  size [mm]  parts  elongation  circularity  convexity\n");
  for (const Outline& outline : read_outlines(o.outlines, o.unit)) {
    const Ring ring = outline.ring();
    std::vector<ConvexPolygon> parts = convex_parts(outline);
    const std::string name = "stone " + std::to_string(panels.size());
    std::printf("%5zu  %9.1f  %5zu  %10.2f  %11.2f  %9.2f\n", panels.size(),
                1e3 * equivalent_diameter(polygon_area(ring)), parts.size(), elongation(ring),
                circularity(ring), convexity(ring));
    panels.push_back({name, std::move(parts)});
  }
  shape_panels(panels, 5, true).save(fs::path(o.out) / "stones.svg");
}

int run(const Options& o) {
  require(o.spread >= 0 && o.spread <= 0.3, "--spread", o.spread, "must lie in [0, 0.3]");
  make_folder(o.out);
  const bool filled = cells(o);
  stones(o);
  const bool met = samples(o);
  std::printf("pictures in %s\n", o.out.c_str());
  return filled && met ? command_line::finished : command_line::failed;
}

}  // namespace

int main(int argc, char** argv) {
  Options o;
  CLI::App app{
      "Shapes: a polygon as Voronoi cells, triangles and convex parts, stones from a file, "
      "and samples\n"
      "of three elongations, measured before and after they are sheared with breakage."};
  app.get_formatter()->column_width(42);
  command_line::OptionTable options(app);
  options.begin_group("Options");
  options.add_number("--particles", o.particles, "RandomAssembly.count", "of each sample");
  options.add_number("--seed", o.seed, "RandomAssembly.seed", "same seed, same bytes");
  options.add_number("--pressure", o.pressure, "BiaxialTest.confining_pressure",
                     "confining pressure [Pa]");
  options.add_number("--strain", o.strain, "BiaxialTest.axial_strain", "axial strain [-]");
  options.add_number("--spread", o.spread, "", "width of the distribution of elongation [-]");
  options.add_text("--outlines", o.outlines, "file of stones, .wkt or .csv");
  options.add_number("--unit", o.unit, "", "of its coordinates [m]");
  options.add_flag("--quick", o.quick, "80 particles and 1 % strain, as a trial");
  options.add_text("--out", o.out, "folder for the pictures (SVG)");
  command_line::parse_or_exit(app, [&] { app.parse(argc, argv); });
  if (o.quick) {
    o.particles = 80;
    o.strain = 0.01;
  }
  return command_line::run_program(options.names(), [&] { return run(o); });
}
