// SPDX-License-Identifier: BSL-1.0
#include <riprap/simulation/stress_query.hpp>

#include <doctest/doctest.h>

#include <support/breakage_passes.hpp>
#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

TEST_CASE("a query gives the stresses that a breakage pass sees, and keeps nothing") {
  const Model model;
  const Rocks rocks{Rock{}};
  const Simulation sim{model, crushed, rocks};
  Pass pass(model);
  const StressQuery query(model, rocks, sim.particles(), sim.contacts(), pass.stage);
  const std::vector<double> ratios = query.failed_ratios();
  CHECK(pass.stage.operator_bytes() == 0);
  const auto& cracks = pass.find(sim);
  REQUIRE(cracks.size() == 2);
  CHECK(ratios[0] == cracks[0].second.failures.ratio());
  CHECK(ratios[3] == cracks[1].second.failures.ratio());
  CHECK(ratios[1] == 0);  // a platen
  // From memory now, with the same bytes.
  CHECK(query.failed_ratios() == ratios);
  CHECK(query.mesh(0).size() == query.element_stress(0).size());
  CHECK(query.element_stress(3).size() > 50);
}
