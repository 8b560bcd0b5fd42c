// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

#include <riprap/particle/random_assembly.hpp>
#include <riprap/simulation/simulation.hpp>
using namespace riprap;

struct SortedSweep {           // boxes sorted along axis 1; each looks ahead as far as it reaches
  double relative_skin = 0.1;  // over the mean diameter [-]
  template <class Visit>
  void visit_pairs(std::span<const Box> boxes, Visit&& visit) const {
    std::vector<BodyIndex> order(boxes.size());
    std::iota(order.begin(), order.end(), BodyIndex{0});
    std::ranges::stable_sort(order, {}, [&](BodyIndex i) { return boxes[i].low.x(); });
    for (auto p = order.begin(); p != order.end(); ++p)
      for (auto q = p + 1; q != order.end() && boxes[*q].low.x() <= boxes[*p].high.x(); ++q)
        if (boxes[*p].overlaps(boxes[*q])) visit(std::min(*p, *q), std::max(*p, *q));
  }
  void validate() const { require_non_negative("SortedSweep.relative_skin", relative_skin); }
};

int main() {
  const Assembly sample = random_assembly({.count = 60, .seed = 1});
  const auto model = Model{}.criterion(NeverFails{});
  Simulation sim{model.broad_phase(SortedSweep{}), sample, Rock{}};
  Simulation twin{model, sample, Rock{}};
  for (int i = 0; i < 20; ++i) sim.step(), twin.step();
  return sim.contacts().pairs().size() == twin.contacts().pairs().size() ? 0 : 1;
}
