// SPDX-License-Identifier: BSL-1.0
// riprap: a LineFit must have std::optional<Line> operator()(std::span<const WeightedPoint>, const
// FailurePlanes&[, const Stress2&[, const LoadedParticle&]]) const or operator()(const
// LoadedParticle&) const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  std::optional<Line> operator()(std::span<const WeightedPoint>, const FailurePlanes&) const {
    return std::nullopt;
  }
};
const Mine mine;

const auto model = Model{}.line_fit(&mine);
