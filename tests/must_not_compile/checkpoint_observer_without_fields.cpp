// SPDX-License-Identifier: BSL-1.0
// riprap: a type that is saved must name its state: template <class Self, class Visit> static void
// for_each_field(Self&, Visit&&) (docs/checkpoints.md)
#include <riprap/checkpoint/fields_of.hpp>
using namespace riprap;

struct Mine {
  double largest_force = 0;
  void after_step(const auto& /*sim*/) { largest_force = 1; }
};

const FieldNode fields = fields_of(Mine{}, "observer");
