// SPDX-License-Identifier: BSL-1.0
// riprap: a type that is saved must name its state: template <class Self, class Visit> static void
// for_each_field(Self&, Visit&&) (docs/checkpoints.md)
#include <riprap/checkpoint/fields_of.hpp>
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  double critical = 0.4;
  bool operator()(const FailureCount& failures) const { return failures.ratio() > critical; }
};

const FieldNode fields = fields_of(Model{}.trigger(Mine{}), "model");
