// SPDX-License-Identifier: BSL-1.0
// riprap: a Batch of a NarrowPhase must have a type Of, capacity, size(), clear(), bool add(Ring,
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  struct Cache {};
  struct Batch {
    using Of = Mine;
    static constexpr std::size_t capacity = 2;
    static constexpr std::size_t kinds = 2;
    std::size_t size() const { return 0; }
    void clear() {}
    bool add(Ring, Ring, const Cache&, ContactGeometry&) { return false; }
  };
  unsigned find(const Batch&) const { return 0; }
  std::optional<ContactGeometry> operator()(Ring, Ring, Cache&) const { return std::nullopt; }
};

const auto model = Model{}.narrow_phase(Mine{});
