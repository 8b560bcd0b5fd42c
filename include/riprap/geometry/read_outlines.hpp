// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Reads outlines, convex or concave, from files: well-known text (WKT) or comma-separated values
/// (CSV). Optional: not part of riprap.hpp.

#include <filesystem>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/geometry/outline.hpp>
#include <riprap/geometry/read_polygons.hpp>

namespace riprap {

/// The outlines of a file NAME.wkt or NAME.csv, in the forms that read_polygons takes; rings may be
/// concave and have any number of vertices.
/// @param unit of the coordinates in the file [m]: 1.0_mm, or 1 for metres
/// Throws InvalidInput with the file, the line or lines, the value and the rule for anything else,
/// and for a ring that is no Outline.
[[nodiscard]] inline std::vector<Outline> read_outlines(const std::filesystem::path& path,
                                                        double unit) {
  require_positive("read_outlines: unit", unit);
  std::vector<Outline> outlines;
  internal::read_rings(path, [&](std::vector<Vec2> ring) {
    for (Vec2& v : ring) v = unit * v;
    outlines.push_back(Outline(std::move(ring)));
  });
  return outlines;
}

}  // namespace riprap
