// SPDX-License-Identifier: BSL-1.0
#pragma once
// Peak, end, dilation and balance of a direct shear test.

#include <vector>

#include "box_test.hpp"

namespace direct_shear {

struct Strength {
  double displacement = 0;  // of the lower half [m]
  double normal = 0;        // on the parting plane [Pa]
  double shear = 0;         // [Pa]

  [[nodiscard]] double ratio() const { return shear / normal; }
};

struct Features {
  Strength peak{};            // of the mean over five intervals
  Strength end{};             // over the last fifth of the way
  double dilation = 0;        // rise of the lid over the way of the lower half, around the peak [-]
  double imbalance = 0;       // mean difference of the two shear forces over their mean [-]
  double mean_offset = 0;     // difference of the means of the two shear forces over their mean [-]
  double plane_over_lid = 0;  // normal force through the plane over that on the lid, mean [-]
};

// Throws InvalidInput for less than five records.
[[nodiscard]] Features features(const BoxResult& result);

}  // namespace direct_shear
