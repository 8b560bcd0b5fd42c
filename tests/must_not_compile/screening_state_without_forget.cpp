// SPDX-License-Identifier: BSL-1.0
// riprap: the State of a Screening must be made from the breakage part and the stress part of a
// model, and have forget(i)
#include <riprap/simulation/breakage_stage.hpp>
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  template <class BreakagePart, class StressPart>
  struct State {
    State(const BreakagePart&, const StressPart&) {}
    void find_candidates(const auto&, ContactLoads&, auto&&, std::vector<BodyIndex>&, auto&&) {}
  };
};

const auto model = Model{}.screening(Mine{});
const BreakageStage<decltype(model)> stage(model);
