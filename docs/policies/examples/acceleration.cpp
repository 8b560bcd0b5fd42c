// SPDX-License-Identifier: BSL-1.0
#include <riprap/conformance/acceleration.hpp>
using namespace riprap;

struct RebuildEveryTenthStep {  // with the skin of the broad phase; valid while bodies are slow
  static constexpr bool uses_skin = true;
  template <class Domain>
  struct State : RebuildEveryStep::State<Domain> {  // skips no pair
    int steps = 0;
    bool is_stale(const Particles&, const Domain&, const auto&) { return steps++ % 10 == 0; }
    void invalidate() { steps = 0; }
  };
};
static_assert(NeighbourList<RebuildEveryTenthStep>);

int main() {
  const auto model = Model{}.neighbour_list(RebuildEveryTenthStep{}).screening(EvaluateAll{});
  return acceleration_violations(model).empty() ? 0 : 1;
}
