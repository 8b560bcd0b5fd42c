// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Reads .vtp files back, strictly: the part of VTK's XML format of polygonal data that has a piece
/// of polygons or lines with values of its cells, as text.

#include <charconv>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <riprap/core/vec2.hpp>
#include <support/svg_document.hpp>

namespace riprap::test {

/// A .vtp file as it was read.
struct VtpDocument {
  struct Array {
    std::string type;
    std::size_t components = 1;
    std::vector<double> values;
  };
  std::size_t polygons = 0;  ///< as announced
  std::size_t lines = 0;
  std::vector<std::vector<Vec2>> cells;  ///< points of each cell
  std::map<std::string, Array> arrays;

  [[nodiscard]] const std::vector<double>& values(const std::string& name) const {
    return arrays.at(name).values;
  }
};

namespace vtp {

inline void demand(bool holds, const std::string& what) {
  if (!holds) throw std::runtime_error("vtp: " + what);
}

/// All numbers of a text that white space separates; whole ones for Int64.
[[nodiscard]] inline std::vector<double> numbers(std::string_view text, const std::string& type) {
  demand(type == "Int64" || type == "Float64", "type " + type);
  std::vector<double> out;
  while (true) {
    const std::size_t begin = text.find_first_not_of(" \n");
    if (begin == text.npos) return out;
    text.remove_prefix(begin);
    const std::string_view word = text.substr(0, text.find_first_of(" \n"));
    double value = 0;
    std::int64_t whole = 0;
    const char* end = word.data() + word.size();
    const auto read = type == "Int64" ? std::from_chars(word.data(), end, whole)
                                      : std::from_chars(word.data(), end, value);
    demand(read.ec == std::errc() && read.ptr == end, "no number: " + std::string(word));
    out.push_back(type == "Int64" ? static_cast<double>(whole) : value);
    text.remove_prefix(word.size());
  }
}

[[nodiscard]] inline std::size_t count(const SvgElement& piece, const std::string& key) {
  return static_cast<std::size_t>(piece.number(key));
}

}  // namespace vtp

/// Throws std::runtime_error at anything that is not of this format or does not fit together.
[[nodiscard]] inline VtpDocument read_vtp(const std::string& text) {
  using vtp::demand;
  const auto elements = svg_elements(text);
  demand(elements.size() > 3 && elements[0].name == "VTKFile" &&
             elements[0].attribute("type") == "PolyData" && elements[1].name == "PolyData" &&
             elements[2].name == "Piece",
         "not a file of polygonal data");
  const SvgElement& piece = elements[2];
  VtpDocument out;
  out.polygons = vtp::count(piece, "NumberOfPolys");
  out.lines = vtp::count(piece, "NumberOfLines");
  std::map<std::string, VtpDocument::Array> structure;
  std::string part;
  for (std::size_t i = 3; i < elements.size(); ++i) {
    const SvgElement& e = elements[i];
    if (e.name != "DataArray") {
      part = e.name;
      continue;
    }
    demand(e.attribute("format") == "ascii", "format");
    const std::string type = e.attribute("type");
    VtpDocument::Array array{type, vtp::count(e, "NumberOfComponents"), vtp::numbers(e.text, type)};
    auto& place = part == "CellData" ? out.arrays : structure;
    demand(place.emplace(e.attribute("Name"), std::move(array)).second, "a name twice");
    demand(part == "CellData" || part == "Points" || part == "Lines" || part == "Polys",
           "part " + part);
    demand(part != "Lines" || out.polygons == 0, "polygons announced, lines given");
    demand(part != "Polys" || out.lines == 0, "lines announced, polygons given");
  }
  const auto& points = structure.at("Points");
  const auto& connectivity = structure.at("connectivity").values;
  const auto& offsets = structure.at("offsets").values;
  demand(points.components == 3 && points.values.size() == 3 * vtp::count(piece, "NumberOfPoints"),
         "points");
  demand(offsets.size() == out.polygons + out.lines, "cells");
  std::size_t at = 0;
  for (const double end : offsets) {
    out.cells.emplace_back();
    for (; at < static_cast<std::size_t>(end); ++at) {
      const auto point = static_cast<std::size_t>(connectivity.at(at));
      demand(points.values.at(3 * point + 2) == 0, "a point off the plane");
      out.cells.back().push_back({points.values.at(3 * point), points.values.at(3 * point + 1)});
    }
  }
  demand(at == connectivity.size(), "connectivity");
  for (const auto& [name, array] : out.arrays)
    demand(array.values.size() == array.components * out.cells.size(), "array " + name);
  return out;
}

}  // namespace riprap::test
