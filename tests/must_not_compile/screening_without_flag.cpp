// SPDX-License-Identifier: BSL-1.0
// riprap: a Screening must have static constexpr bool skips_particles and template
// <class BreakagePart, class StressPart> class State
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  template <class BreakagePart, class StressPart>
  using State = EvaluateAll::State<BreakagePart, StressPart>;
};

const auto model = Model{}.screening(Mine{});
