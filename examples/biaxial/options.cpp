// SPDX-License-Identifier: BSL-1.0
// Command line of the biaxial example.

#include "options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <stdexcept>

namespace {

// "3-5" or "4".
void read_vertices(const std::string& text, Options& options) {
  const std::size_t dash = text.find('-');
  try {
    std::size_t used = 0;
    const unsigned long low = std::stoul(text, &used);
    if (used != std::min(dash, text.size())) throw std::invalid_argument(text);
    unsigned long high = low;
    if (dash != std::string::npos) {
      high = std::stoul(text.substr(dash + 1), &used);
      if (used != text.size() - dash - 1) throw std::invalid_argument(text);
    }
    if (std::max(low, high) > riprap::max_polygon_vertices) throw std::out_of_range(text);
    options.fewest_vertices = static_cast<unsigned>(low);
    options.most_vertices = static_cast<unsigned>(high);
  } catch (const std::logic_error&) {
    throw CLI::ValidationError("--vertices", "'" + text +
                                                 "' is neither a count such as 4 nor a "
                                                 "range such as 3-5, of at most 64");
  }
}

// What goes together, and with this build.
void check_combination(const Options& options) {
#ifndef _OPENMP
  if (options.threads > 1)
    throw CLI::ValidationError("--threads", "this program was built without OpenMP, which was not "
                                            "found: it has one thread");
#endif
  if (options.timer && !options.compiled_in())
    throw CLI::ValidationError("--timer", "goes with the default boundary, contact law, integrator "
                                          "and support only");
}

}  // namespace

Options read_options(int argc, char** argv) {
  Options o;
  std::string breakage = "on";
  std::string vertices = "3-5";
  CLI::App app{
      "Biaxial test on an assembly of random sharp polygons: compaction, relaxation,\n"
      "hydrostatic pressure, shear; curves, pictures and a summary are written to a folder."};
  app.get_formatter()->column_width(42);
  app.option_defaults()->always_capture_default();
  app.add_option("--particles", o.particles, "particles, those of the boundary included");
  app.add_option("--pressure", o.pressure, "confining pressure [Pa]");
  app.add_option("--strain", o.strain, "axial strain at the end [-]");
  app.add_option("--seed", o.seed, "seed of the assembly; same seed, same bytes");
  app.add_option("--breakage", breakage, "may particles break?")
      ->check(CLI::IsMember({"on", "off"}));
  app.add_option("--criterion", o.criterion, "failure of an element")
      ->check(CLI::IsMember({"hoek-brown", "mohr-coulomb", "griffith", "modified-griffith",
                             "murrell", "hobbs", "franklin"}));
  app.add_option("--line-fit", o.line_fit, "crack line: weighted X, Y, or the paper's choice")
      ->check(CLI::IsMember({"xy", "x", "y"}));
  app.add_option("--support", o.support, "of a particle in its stress analysis")
      ->check(CLI::IsMember({"inertia-relief", "pinned"}));
  app.add_option("--boundary", o.boundary,
                 "what encloses the sample: a ring of particles, four platens, a periodic cell")
      ->check(CLI::IsMember({"particles", "platens", "periodic"}));
  app.add_option("--contact", o.contact, "law: linear springs, overlap area, springs with dashpot")
      ->check(CLI::IsMember({"linear", "area", "dashpot"}));
  app.add_option("--integrator", o.integrator, "symplectic Euler or velocity Verlet")
      ->check(CLI::IsMember({"euler", "verlet"}));
  app.add_option("--mean-diameter", o.mean_diameter, "of the circles of equal area [m]");
  app.add_option("--thickness", o.thickness, "out of plane [m]");
  app.add_option("--vertices", vertices, "of a polygon: a count or a range [-]");
  app.add_option("--mesh-triangles", o.mesh_triangles, "per particle [-]");
  app.add_option("--ratf", o.ratf, "share of failed elements that breaks a particle [-]");
  app.add_option("--check-every", o.check_every, "steps between stress checks [-]");
  app.add_option("--inertial-number", o.inertial_number, "of shear, sets its rate [-]");
  app.add_option("--plane", o.plane, "plane stress or plane strain")
      ->check(CLI::IsMember({"stress", "strain"}));
  app.add_option("--minimum-piece-area", o.minimum_piece_area,
                 "over the mean area of the intact particles [-]");
  app.add_option("--maximum-piece-aspect", o.maximum_piece_aspect,
                 "of a piece, diameter over least width [-]");
  app.add_option("--out", o.out, "folder for the results");
  app.add_flag("--paraview", o.paraview, "write a series for ParaView into the folder as well");
  app.add_option("--threads", o.threads, "that share the work; changes no result")
      ->check(CLI::Range(1, 1024));
  app.add_flag("--timer", o.timer, "print which part of a step takes how much time");
  try {
    app.parse(argc, argv);
    read_vertices(vertices, o);
    check_combination(o);
  } catch (const CLI::ParseError& error) {
    std::exit(app.exit(error));
  }
  o.breakage = breakage == "on";
  return o;
}

AnyCriterion chosen_criterion(const Options& options) {
  if (options.criterion == "mohr-coulomb") return {riprap::MohrCoulomb{}};
  if (options.criterion == "griffith") return {riprap::Griffith{}};
  if (options.criterion == "modified-griffith") return {riprap::ModifiedGriffith{}};
  if (options.criterion == "murrell") return {riprap::Murrell{}};
  if (options.criterion == "hobbs") return {riprap::Hobbs{}};
  if (options.criterion == "franklin") return {riprap::Franklin{}};
  return {riprap::HoekBrown{}};
}

AnyLineFit chosen_line_fit(const Options& options) {
  if (options.line_fit == "x") return {riprap::WeightedX{}};
  if (options.line_fit == "y") return {riprap::WeightedY{}};
  return {riprap::WeightedXY{}};
}

AnyPlane chosen_plane(const Options& options) {
  if (options.plane == "strain") return {riprap::PlaneStrain{}};
  return {riprap::PlaneStress{}};
}

AnyContact chosen_contact(const Options& options) {
  if (options.contact == "area") {
    // The stiffness that a chord of the mean diameter has does not change with the size.
    riprap::OverlapAreaSpring law;
    const double size = options.mean_diameter / law.largest_chord;
    law.area_stiffness /= size * size;
    law.largest_chord = options.mean_diameter;
    return {law};
  }
  if (options.contact == "dashpot") return {riprap::SpringDashpot{}};
  return {riprap::LinearSpringCoulomb{}};
}

AnyIntegrator chosen_integrator(const Options& options) {
  if (options.integrator == "verlet") return {riprap::VelocityVerlet{}};
  return {riprap::SymplecticEuler{}};
}

AnySupport chosen_support(const Options& options) {
  if (options.support == "pinned") return {riprap::TwoPinnedContacts{}};
  return {riprap::InertiaRelief{}};
}

riprap::RandomAssembly chosen_assembly(const Options& options) {
  return {.count = options.particles,
          .mean_diameter = options.mean_diameter,
          .thickness = options.thickness,
          .seed = options.seed,
          .shape = {.fewest_vertices = options.fewest_vertices,
                    .most_vertices = options.most_vertices}};
}
