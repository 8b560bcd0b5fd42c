// SPDX-License-Identifier: BSL-1.0
// riprap: a Support must have void apply_reactions(std::span<BoundaryLoad>, const
// InfluenceOperator&) const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  static constexpr bool needs_flexibility = false;
  void apply_reactions(std::vector<BoundaryLoad>& loads, const InfluenceOperator&) const {
    loads.clear();
  }
};

const auto model = Model{}.support(Mine{});
