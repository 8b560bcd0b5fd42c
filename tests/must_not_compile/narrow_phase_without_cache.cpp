// SPDX-License-Identifier: BSL-1.0
// riprap: a NarrowPhase must have a type Cache that can be default-constructed and copied
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  std::optional<ContactGeometry> operator()(Ring, Ring) const { return std::nullopt; }
};

const auto model = Model{}.narrow_phase(Mine{});
