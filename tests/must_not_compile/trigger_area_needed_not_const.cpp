// SPDX-License-Identifier: BSL-1.0
// riprap: failed_area_needed of a Trigger must be double failed_area_needed() const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  bool operator()(const FailureCount& failures) const { return failures.area_ratio() > 0.5; }
  double failed_area_needed() { return 0.5; }
};

const auto model = Model{}.trigger(Mine{});
