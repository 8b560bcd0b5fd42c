// SPDX-License-Identifier: BSL-1.0
// riprap: a LineFit must have std::optional<Line> operator()(std::span<const WeightedPoint>, const
// FailurePlanes&[, const Stress2&[, const LoadedParticle&]]) const or operator()(const
// LoadedParticle&) const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  Vec2 operator()(const LoadedParticle& particle) const { return particle.centroid(); }
};

const auto model = Model{}.line_fit(Mine{});
