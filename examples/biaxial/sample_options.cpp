// SPDX-License-Identifier: BSL-1.0
// The options of the assembly, the test and the rock.

#include <algorithm>

#include "option_groups.hpp"

namespace {

using command_line::OptionTable;

using Numbers = std::vector<command_line::Member<double>>;

// "3-5" or "4".
void read_vertices(const std::string& text, riprap::PolygonShape& shape) {
  const std::size_t dash = std::min(text.find('-'), text.size());
  const auto low = command_line::number_from<unsigned>(text.substr(0, dash));
  const auto high =
      dash == text.size() ? low : command_line::number_from<unsigned>(text.substr(dash + 1));
  if (!low || !high || std::max(*low, *high) > riprap::max_polygon_vertices)
    throw CLI::ValidationError("--vertices", "'" + text +
                                                 "' is neither a count such as 4 nor a range such "
                                                 "as 3-5, of at most 64");
  shape.fewest_vertices = *low;
  shape.most_vertices = *high;
}

std::string vertices_text(const riprap::PolygonShape& shape) {
  return std::to_string(shape.fewest_vertices) + "-" + std::to_string(shape.most_vertices);
}

void add_assembly(OptionTable& table, Options& options) {
  riprap::RandomAssembly& a = options.assembly;
  table.begin_group("Assembly");
  table.add_number("--particles", a.count, "RandomAssembly.count",
                   "particles, those of the boundary included");
  table.add_number("--seed", a.seed, "RandomAssembly.seed", "same seed, same bytes");
  table.add_number("--mean-diameter", a.mean_diameter, "RandomAssembly.mean_diameter",
                   "of the circles of equal area [m]");
  table.add_number("--smallest-diameter", a.smallest_diameter, "RandomAssembly.smallest_diameter",
                   "over the mean; diameters are uniform in between [-]");
  table.add_number("--largest-diameter", a.largest_diameter, "RandomAssembly.largest_diameter",
                   "over the mean [-]");
  table.add_text(
      "--grading", options.grading,
      "sieve curve (CSV: size [m], 0.02 for 20 mm; passing [-]) in place of the diameters");
  table.add_number("--thickness", a.thickness, "RandomAssembly.thickness", "out of plane [m]");
  table.add_text(
      "--vertices", "of a polygon: a count or a range [-]",
      [&a](const std::string& text) { read_vertices(text, a.shape); },
      [&a] { return vertices_text(a.shape); },
      {"PolygonShape.fewest_vertices", "PolygonShape.most_vertices"});
  table.add_number("--smallest-axis-ratio", a.shape.smallest_axis_ratio,
                   "PolygonShape.smallest_axis_ratio",
                   "of the ellipse that the vertices lie on [-]");
  table.add_number("--largest-axis-ratio", a.shape.largest_axis_ratio,
                   "PolygonShape.largest_axis_ratio", "of that ellipse [-]");
  table.add_number("--angle-jitter", a.shape.angle_jitter, "PolygonShape.angle_jitter",
                   "of the vertices, over the angle between them [-]");
  table.add_text("--outlines", options.outlines,
                 "convex outlines (WKT or CSV) in place of random polygons");
  table.add_number("--solid-fraction", a.solid_fraction, "RandomAssembly.solid_fraction",
                   "before compaction [-]");
  table.add_number("--dense-fraction",
                   Numbers{{&a.dense_fraction, "RandomAssembly.dense_fraction", "particles"}},
                   "expected after compaction, sets the number in the ring [-]", "--boundary");
  table.add_number("--boundary-spacing",
                   Numbers{{&a.boundary_spacing, "RandomAssembly.boundary_spacing", "particles"}},
                   "of the ring when dense, over the particles' extent [-]", "--boundary");
}

void add_test(OptionTable& table, Options& options) {
  riprap::BiaxialTest& t = options.test;
  table.begin_group("Test");
  const auto number = [&](const std::string& option, auto& value, const std::string& member,
                          const std::string& description) {
    table.add_number(option, value, "BiaxialTest." + member, description);
  };
  number("--pressure", t.confining_pressure, "confining_pressure", "confining pressure [Pa]");
  number("--strain", t.axial_strain, "axial_strain", "axial strain at the end [-]");
  number("--inertial-number", t.inertial_number, "inertial_number", "of shear, sets its rate [-]");
  number("--record-every", t.record_every, "record_every", "axial strain between records [-]");
  table.add_flag("--paraview", options.paraview,
                 "write a series for ParaView into the folder as well");
  table.add_flag("--frames", options.frames,
                 "write frames into the folder as well, for examples/run replay");
  number("--jam-pressure", t.jam_pressure, "jam_pressure",
         "mean stress at which compaction ends [Pa]");
  number("--jam-kinetic-ratio", t.jam_kinetic_ratio, "jam_kinetic_ratio",
         "kinetic over stored energy below which it ends [-]");
  number("--compaction-inertial-number", t.compaction_inertial_number, "compaction_inertial_number",
         "at the jam pressure [-]");
  number("--rest-unbalanced-force", t.rest_unbalanced_force, "rest_unbalanced_force",
         "that ends relaxation [-]");
  number("--hydrostatic-tolerance", t.hydrostatic_tolerance, "hydrostatic_tolerance",
         "on both normal stresses at the confining pressure [-]");
  number("--hydrostatic-unbalanced-force", t.hydrostatic_unbalanced_force,
         "hydrostatic_unbalanced_force", "that ends the stage of hydrostatic pressure [-]");
  number("--confinement-tolerance", t.confinement_tolerance, "confinement_tolerance",
         "on the mean lateral stress in shear [-]");
  number("--most-steps", t.most_steps, "most_steps", "of each stage before shear [-]");
}

void add_rock(OptionTable& table, riprap::Rock& rock) {
  table.begin_group("Rock");
  table.add_number("--young", rock.young, "Rock.young", "Young's modulus [Pa]");
  table.add_number("--poisson", rock.poisson, "Rock.poisson", "Poisson's ratio [-]");
  table.add_number("--density", rock.density, "Rock.density", "[kg/m^3]");
}

}  // namespace

void add_sample_and_test(OptionTable& table, Options& options) {
  add_assembly(table, options);
  add_test(table, options);
  add_rock(table, options.rock);
}
