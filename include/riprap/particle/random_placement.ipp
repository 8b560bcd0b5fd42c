// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <riprap/core/errors.hpp>
#include <riprap/particle/random_placement.hpp>

namespace riprap {

RIPRAP_INLINE void RandomAssembly::validate() const {
  require(count >= 30, "RandomAssembly.count", count, "must be 30 or more");
  require_positive("RandomAssembly.mean_diameter", mean_diameter);
  require_positive("RandomAssembly.thickness", thickness);
  require(smallest_diameter > 0 && smallest_diameter <= 1, "RandomAssembly.smallest_diameter",
          smallest_diameter, "must lie in (0, 1]");
  require(largest_diameter >= 1 && largest_diameter <= 10, "RandomAssembly.largest_diameter",
          largest_diameter, "must lie in [1, 10]");
  require(solid_fraction >= 0.05 && solid_fraction <= 0.5, "RandomAssembly.solid_fraction",
          solid_fraction, "must lie in [0.05, 0.5] (random placement jams above)");
  require(dense_fraction > solid_fraction && dense_fraction <= 1, "RandomAssembly.dense_fraction",
          dense_fraction, "must lie above solid_fraction and be at most 1");
  require(boundary_spacing > 0 && boundary_spacing <= 2, "RandomAssembly.boundary_spacing",
          boundary_spacing, "must lie in (0, 2]");
  require(diameters.empty() || diameters.size() == count, "RandomAssembly.diameters.size()",
          static_cast<double>(diameters.size()), "must be 0 or RandomAssembly.count");
  require_positive("RandomAssembly.aspect_ratio", aspect_ratio);
  require(walls == Motion::platen || walls == Motion::wall, "RandomAssembly.walls",
          static_cast<double>(walls), "must be Motion::platen or Motion::wall");
  for (const double d : diameters) require_positive("RandomAssembly.diameters", d);
  shape.validate();
  if (!prescribed_shape) return;
  require(outlines.empty(), "RandomAssembly.outlines.size()", static_cast<double>(outlines.size()),
          "must be 0 where prescribed_shape is given");
  prescribed_shape->validate();
}

}  // namespace riprap
