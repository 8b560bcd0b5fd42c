// SPDX-License-Identifier: BSL-1.0
// riprap: a BroadPhase must have template <class Visit> void visit_pairs(std::span<const Box>,
// Visit&&) const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  double relative_skin = 0.1;
  void visit_pairs(std::span<const Box>, void (*)(BodyIndex, BodyIndex)) const {}
};

const auto model = Model{}.broad_phase(Mine{});
