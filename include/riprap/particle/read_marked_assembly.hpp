// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Reads an assembly with its boundary from a table: every particle has a motion. Optional: not
/// part of riprap.hpp.

#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/geometry/read_polygons.hpp>
#include <riprap/particle/assembly.hpp>
#include <riprap/particle/body.hpp>

namespace riprap {

namespace internal {

/// The motion of a name, that of the enumerator.
[[nodiscard]] inline Motion motion_of(const CsvReader& rows, std::size_t column) {
  constexpr std::array<std::pair<const char*, Motion>, 5> names{
      {{"free", Motion::free},
       {"prescribed", Motion::prescribed},
       {"strain_field", Motion::strain_field},
       {"platen", Motion::platen},
       {"wall", Motion::wall}}};
  for (const auto& [name, motion] : names)
    if (rows.text(column) == name) return motion;
  rows.fail(column, "must be free, prescribed, strain_field, platen or wall");
}

}  // namespace internal

/// The particles of a table with the header `id,motion,x,y`, where they stand and in its order: as
/// read_csv_polygons takes it, with a motion in every row, the same for all rows of an id. The ring
/// of StrainField has `strain_field`; the platens of RigidPlatens are the first four particles,
/// right, left, top and bottom.
/// @param thickness out of plane [m]
/// @param unit of the coordinates in the file [m]: 1.0_mm, or 1 for metres
/// Throws InvalidInput with the file, the line or lines, the value and the rule.
[[nodiscard]] inline Assembly read_marked_assembly(const std::filesystem::path& path,
                                                   double thickness, double unit) {
  require_positive("read_marked_assembly: unit", unit);
  Assembly assembly{.thickness = thickness, .particles = {}};
  Motion motion = Motion::free;
  auto file = internal::open_text(path);
  internal::read_csv_rings(
      file, path.string(), "id,motion,x,y",
      [&](const internal::CsvReader& rows, bool is_first) {
        const Motion now = internal::motion_of(rows, 1);
        if (!is_first && now != motion) rows.fail(1, "must be the same in all rows of an id");
        motion = now;
      },
      // A ring is taken before the first row of the next one is seen.
      [&](std::vector<Vec2> ring) {
        for (Vec2& v : ring) v = unit * v;
        assembly.particles.push_back(
            {.polygon = internal::polygon_of_ring(std::move(ring)), .motion = motion});
      });
  assembly.validate();
  return assembly;
}

}  // namespace riprap
