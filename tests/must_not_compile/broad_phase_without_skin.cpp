// SPDX-License-Identifier: BSL-1.0
// riprap: a BroadPhase must have double relative_skin
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  template <class Visit>
  void visit_pairs(std::span<const Box>, Visit&&) const {}
};

const auto model = Model{}.broad_phase(Mine{});
