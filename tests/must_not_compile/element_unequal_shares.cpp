// SPDX-License-Identifier: BSL-1.0
// riprap: an Element must have static constexpr std::array<TrianglePoint, N> sampling_points whose
// shares are equal and sum to 1
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine : ConstantStrainTriangle {
  static constexpr std::array<TrianglePoint, 2> sampling_points{
      TrianglePoint{{0.5, 0.25, 0.25}, 0.25}, TrianglePoint{{0.25, 0.375, 0.375}, 0.75}};
};

const auto model = Model{}.element(Mine{});
