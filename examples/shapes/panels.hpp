// SPDX-License-Identifier: BSL-1.0
#pragma once
// Pictures of polygons side by side.

#include <cstddef>
#include <string>
#include <vector>

#include <riprap/geometry/convex_polygon.hpp>
#include <riprap/output/svg.hpp>

struct ShapePanel {
  std::string title;
  std::vector<riprap::ConvexPolygon> polygons;
};

// Panels in rows of `columns`, all to one scale if `same_scale`.
riprap::Svg shape_panels(const std::vector<ShapePanel>& panels, std::size_t columns,
                         bool same_scale);
