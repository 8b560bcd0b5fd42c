// SPDX-License-Identifier: BSL-1.0
// riprap: is_linear of a Support must be bool is_linear() const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  static constexpr bool needs_flexibility = false;
  void apply_reactions(std::span<BoundaryLoad>, const InfluenceOperator&) const {}
  bool is_linear() { return true; }
};

const auto model = Model{}.support(Mine{});
