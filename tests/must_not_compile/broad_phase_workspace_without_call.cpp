// SPDX-License-Identifier: BSL-1.0
// riprap: a BroadPhase with a type Workspace must have template <class Visit> void
// visit_pairs(std::span<const Box>, Workspace&, Visit&&) const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  double relative_skin = 0.1;
  struct Workspace {};
  template <class Visit>
  void visit_pairs(std::span<const Box>, Visit&&) const {}
};

const auto model = Model{}.broad_phase(Mine{});
