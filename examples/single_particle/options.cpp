// SPDX-License-Identifier: BSL-1.0
// Command line of the single-particle example.

#include "options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <sstream>

#include <riprap/geometry/read_wkt.hpp>

#include "../command_line/option_table.hpp"
#include "../command_line/program.hpp"

namespace single_particle {

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
  std::size_t count = 0;
  bool good = true;
  std::istringstream words(text);
  for (std::string word; words >> word && good; ++count) {
    const auto number = command_line::number_from<double>(word);
    good = number.has_value() && count < N;
    if (good) values[count] = *number;
  }
  if (!good || count != N) throw riprap::InvalidInput(name + " = '" + text + "': must be " + rule);
  return values;
}

riprap::ConvexPolygon polygon_from(const std::string& text) {
  std::vector<riprap::Vec2> vertices;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t comma = std::min(text.find(',', begin), text.size());
    const auto [x, y] = numbers<2>("--polygon vertex " + std::to_string(vertices.size()),
                                   text.substr(begin, comma - begin),
                                   "two numbers x y [m], vertices separated by commas");
    vertices.emplace_back(x, y);
    begin = comma + 1;
  }
  return riprap::ConvexPolygon(std::move(vertices));
}

PointForce force_from(const std::string& text) {
  const auto [x, y, fx, fy] = numbers<4>("--force", text, "four numbers x y fx fy [m, N]");
  return {{x, y}, {fx, fy}};
}

riprap::ConvexPolygon polygon_in_file(const std::string& name) {
  std::ifstream file(name, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file) throw riprap::InvalidInput("--wkt = " + name + ": must be a file that can be read");
  try {
    return riprap::read_wkt_polygon(text);
  } catch (const riprap::InvalidInput& error) {
    throw riprap::InvalidInput("--wkt = " + name + ": " + error.what());
  }
}

void add_options(command_line::OptionTable& table, CLI::App& app, Options& o) {
  table.begin_group("Options");
  table.add_text("--polygon", o.polygon, "vertices 'x y, x y, ...' [m], convex, counter-clockwise")
      ->excludes(table.add_text("--wkt", o.wkt, "file with a POLYGON in well-known text [m]"));
  app.add_option("--force", o.forces,
                 "'x y fx fy' [m, N], at the nearest boundary point; repeatable")
      ->expected(1, 1000)
      ->allow_extra_args(false);
  table.add_choice("--criterion", o.criterion, {"hoek-brown", "mohr-coulomb"},
                   "failure of an element");
  table.add_choice("--support", o.support, {"inertia-relief", "pinned"},
                   "of the particle in its stress analysis");
  table.add_number("--mesh-triangles", o.mesher.triangles, "UniformMesher.triangles",
                   "wanted in the mesh [-]");
  table.add_number("--thickness", o.thickness, "", "out of plane [m]");
  table.add_number("--ratf", o.trigger.critical, "FailedElementRatio.critical",
                   "share of failed elements that breaks the particle [-]");
  table.add_text("--out", o.out, "file for the picture (SVG)");
}

}  // namespace

Options read_options(int argc, char** argv) {
  Options o;
  CLI::App app{
      "One convex polygon under point forces: finite-element stress, failed elements, the two\n"
      "weighted lines and the cut, as numbers and as one picture. Without --polygon or --wkt a\n"
      "pentagon of 16 mm under four forces is taken."};
  app.get_formatter()->column_width(42);
  command_line::OptionTable table(app);
  add_options(table, app, o);
  command_line::parse_or_exit(app, [&] { app.parse(argc, argv); });
  o.names = table.names();
  return o;
}

Case chosen_case(const Options& o) {
  const bool own = !o.polygon.empty() || !o.wkt.empty();
  if (own && o.forces.empty())
    throw riprap::InvalidInput("--force is missing: a polygon of your own needs forces of its own");
  Case c{.polygon = o.wkt.empty() ? polygon_from(own ? o.polygon : default_polygon)
                                  : polygon_in_file(o.wkt)};
  if (o.forces.empty())
    for (const char* text : default_forces) c.forces.push_back(force_from(text));
  for (const std::string& text : o.forces) c.forces.push_back(force_from(text));
  if (o.criterion == "mohr-coulomb") c.criterion = {riprap::MohrCoulomb{}};
  c.pinned = o.support == "pinned";
  c.mesher = o.mesher;
  c.trigger = o.trigger;
  c.thickness = o.thickness;
  return c;
}

}  // namespace single_particle
