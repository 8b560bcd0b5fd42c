// SPDX-License-Identifier: BSL-1.0
// riprap: strength_factor of a Trigger must be double strength_factor(ParticleId, double
// area) const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  bool operator()(const FailureCount& failures) const { return failures.failed > 0; }
  double strength_factor(ParticleId, double area) { return 1 / area; }
};

const auto model = Model{}.trigger(Mine{});
