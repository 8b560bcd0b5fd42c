// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Reads an assembly from a file of polygons.

#include <filesystem>
#include <vector>

#include <riprap/geometry/read_polygons.hpp>
#include <riprap/particle/assembly.hpp>

namespace riprap {

/// Polygons where they stand, all of one motion.
[[nodiscard]] inline Assembly placed_assembly(const std::vector<ConvexPolygon>& polygons,
                                              double thickness, Motion motion = Motion::free) {
  Assembly assembly{.thickness = thickness, .particles = {}};
  for (const ConvexPolygon& polygon : polygons)
    assembly.particles.push_back({.polygon = polygon, .motion = motion});
  assembly.validate();
  return assembly;
}

/// The polygons of a file NAME.wkt or NAME.csv (see read_polygons) as free particles, where they
/// stand in the file and in its order. Particles that lie in one another are refused by Simulation.
/// @param thickness out of plane [m]
/// Throws InvalidInput with the file, the line, the value and the rule.
[[nodiscard]] inline Assembly read_assembly(const std::filesystem::path& path, double thickness) {
  return placed_assembly(read_polygons(path), thickness);
}

}  // namespace riprap
