// SPDX-License-Identifier: BSL-1.0
// riprap: a Trigger that takes the LoadedParticle alone must not have failed_elements_needed or
// failed_area_needed
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  FailureMode operator()(const LoadedParticle&) const { return FailureMode::tension; }
  std::size_t failed_elements_needed(std::size_t) const { return 1; }
};

const auto model = Model{}.trigger(Mine{});
