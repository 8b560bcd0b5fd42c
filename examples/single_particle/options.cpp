// SPDX-License-Identifier: BSL-1.0
// Command line of the single-particle example.

#include "options.hpp"

#include <CLI/CLI.hpp>
#include <array>
#include <cstdlib>
#include <sstream>

namespace {

// A sharp pentagon with the area of a circle of 16 mm, and four forces in balance.
constexpr auto default_polygon =
    "-0.0084 -0.005, 0.0067 -0.0074, 0.0104 0.0012, 0.0018 0.0078, -0.0074 0.0048";
constexpr std::array default_forces{"-0.00613 -0.00536 1790 6940", "0.00368 -0.00692 1780 6850",
                                    "0.00352 0.00648 -5450 -8980", "-0.00096 0.0069 1880 -4810"};

// Exactly N numbers, separated by blanks.
template <std::size_t N>
std::array<double, N> numbers(const std::string& name, const std::string& text,
                              const std::string& rule) {
  std::array<double, N> values{};
  std::istringstream stream(text);
  bool good = true;
  for (double& value : values) good = good && static_cast<bool>(stream >> value);
  std::string rest;
  if (!good || stream >> rest)
    throw riprap::InvalidInput(name + " = '" + text + "': must be " + rule);
  return values;
}

riprap::ConvexPolygon polygon_from(const std::string& text) {
  std::vector<riprap::Vec2> vertices;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');) {
    const auto [x, y] = numbers<2>("--polygon vertex " + std::to_string(vertices.size()), part,
                                   "two numbers x y [m], vertices separated by commas");
    vertices.emplace_back(x, y);
  }
  return riprap::ConvexPolygon(std::move(vertices));
}

PointForce force_from(const std::string& text) {
  const auto [x, y, fx, fy] = numbers<4>("--force", text, "four numbers x y fx fy [m, N]");
  return {{x, y}, {fx, fy}};
}

}  // namespace

Options read_options(int argc, char** argv) {
  Options o;
  CLI::App app{
      "One convex polygon under point forces: finite-element stress, failed elements, the two\n"
      "weighted lines and the cut, as numbers and as one picture. Without --polygon or --wkt a\n"
      "pentagon of 16 mm under four forces is taken."};
  app.get_formatter()->column_width(42);
  auto* polygon = app.add_option("--polygon", o.polygon,
                                 "vertices 'x y, x y, ...' [m], convex, counter-clockwise");
  app.add_option("--wkt", o.wkt, "file with a POLYGON in well-known text [m]")->excludes(polygon);
  app.add_option("--force", o.forces,
                 "'x y fx fy' [m, N], at the nearest boundary point; repeatable")
      ->expected(1, 1000)
      ->allow_extra_args(false);
  app.option_defaults()->always_capture_default();
  app.add_option("--criterion", o.criterion, "failure of an element")
      ->check(CLI::IsMember({"hoek-brown", "mohr-coulomb"}));
  app.add_option("--support", o.support, "of the particle in its stress analysis")
      ->check(CLI::IsMember({"inertia-relief", "pinned"}));
  app.add_option("--mesh-triangles", o.mesh_triangles, "wanted in the mesh [-]");
  app.add_option("--thickness", o.thickness, "out of plane [m]");
  app.add_option("--ratf", o.ratf, "share of failed elements that breaks the particle [-]");
  app.add_option("--out", o.out, "file for the picture (SVG)");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::exit(app.exit(error));
  }
  return o;
}

Case chosen_case(const Options& o) {
  const bool own = !o.polygon.empty() || !o.wkt.empty();
  if (own && o.forces.empty())
    throw riprap::InvalidInput("--force is missing: a polygon of your own needs forces of its own");
  Case c{.polygon = o.wkt.empty() ? polygon_from(own ? o.polygon : default_polygon)
                                  : read_wkt_file(o.wkt)};
  if (o.forces.empty())
    for (const char* text : default_forces) c.forces.push_back(force_from(text));
  for (const std::string& text : o.forces) c.forces.push_back(force_from(text));
  if (o.criterion == "mohr-coulomb") c.criterion = {riprap::MohrCoulomb{}};
  c.pinned = o.support == "pinned";
  c.mesher.triangles = o.mesh_triangles;
  c.trigger.critical = o.ratf;
  c.thickness = o.thickness;
  return c;
}
