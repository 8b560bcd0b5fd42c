// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A small writer of VTK's XML files of polygons and lines (.vtp).

#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <riprap/core/vec2.hpp>
#include <riprap/output/file.hpp>

namespace riprap {

/// What the cells of a VtpFile are; names as in the file format.
enum class VtpCells { polygons, lines };

/// Cells with values, at z = 0; numbers as text that reads back exactly. A cell that has a point or
/// a value that is not finite is left out, for VTK cannot read such numbers; a comment in the file
/// gives the number of cells left out.
class VtpFile {
 public:
  explicit VtpFile(VtpCells kind) : kind_(kind) {}

  /// Adds a cell with points of its own [m].
  void add_cell(Ring points) {
    Cell cell{.points = {}, .point_count = points.size()};
    for (const Vec2& p : points) append(cell.points, p, cell.finite);
    cells_.push_back(std::move(cell));
  }

  /// Adds an array with a value per cell, in the order of the cells: `value(k)` is a number for
  /// k in [0, cells), or a Vec2, which gets a third component 0.
  template <class Value>
  void add_values(std::string_view name, Value&& value) {
    using Type = std::decay_t<decltype(value(std::size_t{0}))>;
    arrays_.push_back({std::string(name),
                       std::is_integral_v<Type> ? "Int64" : "Float64",
                       std::is_arithmetic_v<Type> ? 1 : 3,
                       {}});
    for (std::size_t k = 0; k < cells_.size(); ++k) {
      std::string text;
      if constexpr (std::is_arithmetic_v<Type>)
        append(text, value(k), cells_[k].finite);
      else
        append(text, Vec2(value(k)), cells_[k].finite);
      arrays_.back().values.push_back(std::move(text));
    }
  }

  [[nodiscard]] std::string document() const {
    const std::string element = kind_ == VtpCells::polygons ? "Polys" : "Lines";
    std::string points;
    std::string connectivity;
    std::string offsets;
    std::size_t point_count = 0;
    std::size_t cell_count = 0;
    for (const Cell& cell : cells_) {
      if (!cell.finite) continue;
      points += cell.points;
      for (std::size_t i = 0; i < cell.point_count; ++i)
        connectivity += std::to_string(point_count++) + "\n";
      offsets += std::to_string(point_count) + "\n";
      ++cell_count;
    }
    std::string values;
    for (const Array& a : arrays_) values += array(a.name, a.type, a.components, joined(a.values));
    const auto count_if = [&](VtpCells kind) {
      return std::to_string(kind == kind_ ? cell_count : 0);
    };
    return "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n<PolyData>\n" +
           note(cells_.size() - cell_count) + "<Piece NumberOfPoints=\"" +
           std::to_string(point_count) + "\" NumberOfVerts=\"0\" NumberOfLines=\"" +
           count_if(VtpCells::lines) + "\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
           count_if(VtpCells::polygons) + "\">\n<CellData>\n" + values + "</CellData>\n<Points>\n" +
           array("Points", "Float64", 3, points) + "</Points>\n<" + element + ">\n" +
           array("connectivity", "Int64", 1, connectivity) + array("offsets", "Int64", 1, offsets) +
           "</" + element + ">\n</Piece>\n</PolyData>\n</VTKFile>\n";
  }
  /// Throws SimulationError if the file cannot be written.
  void save(const std::string& path) const { write_file(path, document()); }

 private:
  struct Cell {
    std::string points;
    std::size_t point_count = 0;
    bool finite = true;  // its points and values
  };
  struct Array {
    std::string name;
    const char* type;
    int components;
    std::vector<std::string> values;  // a text for each cell
  };

  template <class Number>
  static void append(std::string& text, Number value, bool& finite) {
    if constexpr (std::is_floating_point_v<Number>) finite = finite && std::isfinite(value);
    char buffer[32];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
    text.append(buffer, end);
    text += '\n';
  }
  static void append(std::string& text, const Vec2& v, bool& finite) {
    append(text, v.x(), finite);
    append(text, v.y(), finite);
    text += "0\n";
  }
  [[nodiscard]] std::string joined(const std::vector<std::string>& values) const {
    std::string out;
    for (std::size_t k = 0; k < values.size(); ++k)
      if (cells_[k].finite) out += values[k];
    return out;
  }
  [[nodiscard]] static std::string note(std::size_t left_out) {
    if (left_out == 0) return {};
    return "<!-- left out: " + std::to_string(left_out) +
           " cells with numbers that are not finite -->\n";
  }
  [[nodiscard]] static std::string array(std::string_view name, std::string_view type,
                                         int components, const std::string& text) {
    return "<DataArray type=\"" + std::string(type) + "\" Name=\"" + std::string(name) +
           "\" NumberOfComponents=\"" + std::to_string(components) + "\" format=\"ascii\">\n" +
           text + "</DataArray>\n";
  }

  VtpCells kind_;
  std::vector<Cell> cells_;
  std::vector<Array> arrays_;
};

}  // namespace riprap
