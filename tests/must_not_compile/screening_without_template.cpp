// SPDX-License-Identifier: BSL-1.0
// riprap: a Screening must have template <class BreakagePart, class StressPart> class State
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  using State = EvaluateAll::State<BreakageModel<>, StressModel<>>;
};

const auto model = Model{}.screening(Mine{});
