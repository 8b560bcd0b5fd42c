// SPDX-License-Identifier: BSL-1.0
// riprap: failed_elements_needed of a Trigger must be std::size_t
// failed_elements_needed(std::size_t elements) const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  bool operator()(const FailureCount& failures) const { return failures.failed > 0; }
  std::size_t failed_elements_needed(std::size_t) { return 1; }
};

const auto model = Model{}.trigger(Mine{});
