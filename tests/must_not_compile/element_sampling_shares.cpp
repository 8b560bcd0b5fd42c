// SPDX-License-Identifier: BSL-1.0
// riprap: an Element must have static constexpr std::array<TrianglePoint, N> sampling_points whose
// shares are equal and sum to 1
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine : ConstantStrainTriangle {
  static constexpr std::array<TrianglePoint, 2> sampling_points{};
};

const auto model = Model{}.element(Mine{});
