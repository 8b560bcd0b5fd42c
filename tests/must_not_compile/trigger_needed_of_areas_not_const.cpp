// SPDX-License-Identifier: BSL-1.0
// riprap: failed_elements_needed of a Trigger must be std::size_t
// failed_elements_needed(const LargestAreas&) const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  bool operator()(const FailureCount& failures) const { return failures.area_ratio() > 0.5; }
  std::size_t failed_elements_needed(const LargestAreas&) { return 1; }
};

const auto model = Model{}.trigger(Mine{});
