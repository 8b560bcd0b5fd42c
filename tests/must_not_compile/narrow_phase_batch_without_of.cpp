// SPDX-License-Identifier: BSL-1.0
// riprap: a Batch of a NarrowPhase must have a type Of, capacity, size(), clear(), bool add(Ring,
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  struct Cache {};
  struct Batch {
    static constexpr std::size_t capacity = 2;
  };
  std::optional<ContactGeometry> operator()(Ring, Ring, Cache&) const { return std::nullopt; }
};

const auto model = Model{}.narrow_phase(Mine{});
