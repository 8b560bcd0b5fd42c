// SPDX-License-Identifier: BSL-1.0
// Reads a polygon from well-known text with Boost.Geometry.

#include <algorithm>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/geometry/io/wkt/read.hpp>
#include <fstream>
#include <iterator>

#include <riprap/geometry/adapt/boost.hpp>

#include "options.hpp"

riprap::ConvexPolygon read_wkt_file(const std::string& name) {
  std::ifstream file(name);
  if (!file) throw riprap::InvalidInput("--wkt = " + name + ": must be a file that can be read");
  std::string text{std::istreambuf_iterator<char>(file), {}};
  text.erase(text.find_last_not_of(" \t\r\n") + 1);  // refused by the reader
  // Counter-clockwise and open, as riprap has it.
  boost::geometry::model::polygon<riprap::Vec2, false, false> polygon;
  try {
    boost::geometry::read_wkt(text, polygon);
  } catch (const boost::geometry::read_wkt_exception& error) {
    throw riprap::InvalidInput("--wkt = " + name + ": must hold one POLYGON; " + error.what());
  }
  if (!polygon.inners().empty())
    throw riprap::InvalidInput("--wkt = " + name + ": a particle has no holes, this polygon has " +
                               std::to_string(polygon.inners().size()));
  // Well-known text repeats the first vertex at the end.
  std::vector<riprap::Vec2> vertices(polygon.outer().begin(), polygon.outer().end());
  if (vertices.size() > 1 && vertices.front() == vertices.back()) vertices.pop_back();
  if (riprap::area_properties(vertices).area < 0) std::ranges::reverse(vertices);
  return riprap::ConvexPolygon(std::move(vertices));
}
