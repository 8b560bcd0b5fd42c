// SPDX-License-Identifier: BSL-1.0
// riprap: a policy must be copy-constructible, for a Model keeps it by value
#include <memory>
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  std::unique_ptr<double> critical;
  bool operator()(const FailureCount& failures) const { return failures.ratio() > *critical; }
};

const auto model = Model{}.trigger(Mine{});
