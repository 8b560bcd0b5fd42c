// SPDX-License-Identifier: BSL-1.0
// riprap: a Support must have static constexpr bool needs_flexibility
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  void apply_reactions(std::span<BoundaryLoad>, const InfluenceOperator&) const {}
};

const auto model = Model{}.support(Mine{});
