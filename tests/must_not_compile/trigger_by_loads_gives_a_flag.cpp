// SPDX-License-Identifier: BSL-1.0
// riprap: a Trigger must have bool operator()(const FailureCount&[, const LoadedParticle&]) const,
// or FailureMode operator()(const LoadedParticle&) const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  bool operator()(const LoadedParticle& particle) const { return !particle.loads().empty(); }
};

const auto model = Model{}.trigger(Mine{});
