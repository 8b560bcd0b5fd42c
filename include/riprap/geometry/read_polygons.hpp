// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Reads lists of polygons from files: well-known text (WKT) or comma-separated values (CSV).

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <istream>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include <riprap/core/read_csv.hpp>
#include <riprap/geometry/read_wkt.hpp>

namespace riprap {

namespace internal {

/// Collects the vertices of one polygon of a CSV file, row by row.
class CsvRing {
 public:
  [[nodiscard]] bool has(const std::string& id) const { return !vertices_.empty() && id == id_; }
  void begin(const std::string& id, std::size_t line) {
    id_ = id;
    first_line_ = line;
  }
  void add(const Vec2& vertex, std::size_t line) {
    vertices_.push_back(vertex);
    last_line_ = line;
  }
  /// Gives the ring, if there is one, to `take`.
  void finish(const std::string& file, auto& take) {
    if (vertices_.empty()) return;
    try {
      take(std::exchange(vertices_, {}));
    } catch (const InvalidInput& error) {
      throw InvalidInput(file + ", lines " + std::to_string(first_line_) + " to " +
                         std::to_string(last_line_) + ", id '" + id_ + "': " + error.what());
    }
  }

 private:
  std::string id_;
  std::vector<Vec2> vertices_;
  std::size_t first_line_ = 0;
  std::size_t last_line_ = 0;
};

[[noreturn, gnu::cold]] inline void throw_no_polygons(const std::string& file) {
  throw InvalidInput(file + ": no polygons: must have one or more");
}

/// Gives the ring of every line `POLYGON ((x y, x y, ...))` to `take`; an InvalidInput of that gets
/// the name of the file and the line.
void read_wkt_rings(std::istream& in, const std::string& name, auto&& take) {
  LineReader lines(in, name);
  bool any = false;
  for (; lines.next(); any = true) {
    try {
      take(WktReader(lines.line()).read_ring());
    } catch (const InvalidInput& error) {
      lines.fail(error.what());
    }
  }
  if (!any) throw_no_polygons(name);
}

/// Gives the ring of every id of a table to `take`; an InvalidInput of that gets the name of the
/// file and the lines. The columns of the table begin with the id and end with x and y.
/// @param see(rows, is_first) is called with every row, after the ring before it was taken
void read_csv_rings(std::istream& in, const std::string& name, const std::string& header,
                    auto&& see, auto&& take) {
  CsvReader rows(in, name, header);
  const auto x_column = static_cast<std::size_t>(std::count(header.begin(), header.end(), ',')) - 1;
  std::unordered_set<std::string> ids;
  CsvRing ring;
  while (rows.next()) {
    const std::string& id = rows.text(0);
    const std::size_t line = rows.lines().number();
    const bool is_first = !ring.has(id);
    if (is_first) {
      if (id.empty()) rows.fail(0, "must not be empty");
      ring.finish(name, take);
      if (!ids.insert(id).second) rows.fail(0, "its vertices must stand in consecutive rows");
      ring.begin(id, line);
    }
    see(rows, is_first);
    const double x = rows.number(x_column);
    ring.add({x, rows.number(x_column + 1)}, line);
  }
  ring.finish(name, take);
  if (ids.empty()) throw_no_polygons(name);
}

/// The same of a table `id,x,y`.
void read_csv_rings(std::istream& in, const std::string& name, auto&& take) {
  read_csv_rings(
      in, name, "id,x,y", [](const CsvReader& /*rows*/, bool /*is_first*/) {}, take);
}

/// Gives the rings of a file NAME.wkt or NAME.csv to `take`.
void read_rings(const std::filesystem::path& path, auto&& take) {
  const bool is_wkt = path.extension() == ".wkt";
  if (!is_wkt && path.extension() != ".csv")
    throw InvalidInput("file of polygons '" + path.string() + "': must end in .wkt or .csv");
  auto file = open_text(path);
  if (is_wkt)
    read_wkt_rings(file, path.string(), take);
  else
    read_csv_rings(file, path.string(), take);
}

/// Takes rings as polygons.
[[nodiscard]] inline auto polygon_collector(std::vector<ConvexPolygon>& polygons) {
  return
      [&polygons](std::vector<Vec2> ring) { polygons.push_back(polygon_of_ring(std::move(ring))); };
}

}  // namespace internal

/// Polygons [m] of a text with one `POLYGON ((x y, x y, ...))` a line, each as read_wkt_polygon
/// takes it; blank lines and lines that begin with # are skipped. Throws InvalidInput with the name
/// of the file and the line for anything else, and for a text without polygons.
[[nodiscard]] inline std::vector<ConvexPolygon> read_wkt_polygons(std::istream& in,
                                                                  const std::string& name) {
  std::vector<ConvexPolygon> polygons;
  internal::read_wkt_rings(in, name, internal::polygon_collector(polygons));
  return polygons;
}

/// Polygons [m] of a table with the header `id,x,y` and a vertex in every row. The vertices of a
/// polygon have one id, any text, and stand in consecutive rows, either way round; the first may be
/// repeated at the end. Throws InvalidInput with the name of the file, the lines, the value and the
/// rule for anything else, and for a table without rows.
[[nodiscard]] inline std::vector<ConvexPolygon> read_csv_polygons(std::istream& in,
                                                                  const std::string& name) {
  std::vector<ConvexPolygon> polygons;
  internal::read_csv_rings(in, name, internal::polygon_collector(polygons));
  return polygons;
}

/// The polygons of a file. Throws InvalidInput also where it cannot be read, with the reason.
[[nodiscard]] inline std::vector<ConvexPolygon>
read_wkt_polygons(const std::filesystem::path& path) {
  auto file = internal::open_text(path);
  return read_wkt_polygons(file, path.string());
}
[[nodiscard]] inline std::vector<ConvexPolygon>
read_csv_polygons(const std::filesystem::path& path) {
  auto file = internal::open_text(path);
  return read_csv_polygons(file, path.string());
}

/// The polygons of a file NAME.wkt or NAME.csv, as its name has it. Throws InvalidInput for another
/// name.
[[nodiscard]] inline std::vector<ConvexPolygon> read_polygons(const std::filesystem::path& path) {
  std::vector<ConvexPolygon> polygons;
  internal::read_rings(path, internal::polygon_collector(polygons));
  return polygons;
}

}  // namespace riprap
