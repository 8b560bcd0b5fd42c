// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A small writer of VTK's XML files of polygons and lines (.vtp).

#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <riprap/core/vec2.hpp>
#include <riprap/output/file.hpp>

namespace riprap {

/// What the cells of a VtpFile are; names as in the file format.
enum class VtpCells { polygons, lines };

/// Cells with values, at z = 0; numbers as text that reads back exactly.
class VtpFile {
 public:
  explicit VtpFile(VtpCells kind) : kind_(kind) {}

  /// Adds a cell with points of its own [m].
  void add_cell(Ring points) {
    for (const Vec2& p : points) {
      append(points_, p.x());
      append(points_, p.y());
      points_ += "0\n";
      append(connectivity_, point_count_++);
    }
    append(offsets_, point_count_);
    ++cell_count_;
  }

  /// Adds an array with a value per cell, in the order of the cells: `value(k)` is a number for
  /// k in [0, cells), or a Vec2, which gets a third component 0.
  template <class Value>
  void add_values(std::string_view name, Value&& value) {
    using Type = std::decay_t<decltype(value(std::size_t{0}))>;
    std::string text;
    for (std::size_t k = 0; k < cell_count_; ++k) {
      if constexpr (std::is_arithmetic_v<Type>) {
        append(text, value(k));
      } else {
        const Vec2 v = value(k);
        append(text, v.x());
        append(text, v.y());
        text += "0\n";
      }
    }
    constexpr std::string_view type = std::is_integral_v<Type> ? "Int64" : "Float64";
    values_ += array(name, type, std::is_arithmetic_v<Type> ? 1 : 3, text);
  }

  [[nodiscard]] std::string document() const {
    const std::string element = kind_ == VtpCells::polygons ? "Polys" : "Lines";
    return "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n<PolyData>\n"
           "<Piece NumberOfPoints=\"" +
           std::to_string(point_count_) + "\" NumberOfVerts=\"0\" NumberOfLines=\"" +
           count_if(VtpCells::lines) + "\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
           count_if(VtpCells::polygons) + "\">\n<CellData>\n" + values_ +
           "</CellData>\n<Points>\n" + array("Points", "Float64", 3, points_) + "</Points>\n<" +
           element + ">\n" + array("connectivity", "Int64", 1, connectivity_) +
           array("offsets", "Int64", 1, offsets_) + "</" + element +
           ">\n</Piece>\n</PolyData>\n</VTKFile>\n";
  }
  /// Throws SimulationError if the file cannot be written.
  void save(const std::string& path) const { write_file(path, document()); }

 private:
  template <class Number>
  static void append(std::string& text, Number value) {
    char buffer[32];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
    text.append(buffer, end);
    text += '\n';
  }
  [[nodiscard]] static std::string array(std::string_view name, std::string_view type,
                                         int components, const std::string& text) {
    return "<DataArray type=\"" + std::string(type) + "\" Name=\"" + std::string(name) +
           "\" NumberOfComponents=\"" + std::to_string(components) + "\" format=\"ascii\">\n" +
           text + "</DataArray>\n";
  }
  [[nodiscard]] std::string count_if(VtpCells kind) const {
    return std::to_string(kind == kind_ ? cell_count_ : 0);
  }

  VtpCells kind_;
  std::size_t point_count_ = 0;
  std::size_t cell_count_ = 0;
  std::string points_;
  std::string connectivity_;
  std::string offsets_;
  std::string values_;
};

}  // namespace riprap
