// SPDX-License-Identifier: BSL-1.0
#include <riprap/stress/contact_loads.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include <riprap/particle/random_assembly.hpp>
#include <riprap/simulation/simulation.hpp>

using namespace riprap;

TEST_CASE("every particle has its own contacts and no others, across tasks too") {
  Simulation sim{Model{}, random_assembly({.count = 600, .seed = 3}), Rock{}};
  sim.set_breakage(false);
  sim.boundary().set_rate(10, 10);
  for (int i = 0; i < 4000; ++i) sim.step();
  std::vector<std::vector<BodyIndex>> partners(sim.particles().size());
  sim.contacts().for_each_touching([&](const auto& c) {
    partners[c.a].push_back(c.b);
    partners[c.b].push_back(c.a);
  });
  ContactLoads loads;
  loads.begin(sim.contacts(), partners.size());
  std::size_t across = 0;
  for (BodyIndex i = 0; i < partners.size(); ++i) {
    CHECK(loads.of(i).empty());
    loads.gather(sim.contacts(), i);
    const std::vector<ContactLoad> alone = loads_on(sim.contacts(), i);
    REQUIRE(loads.of(i).size() == partners[i].size());
    REQUIRE(alone.size() == partners[i].size());
    Wrench sum;
    for (std::size_t c = 0; c < alone.size(); ++c) {
      const ContactLoad& load = loads.of(i)[c];
      CHECK(load.partner == partners[i][c]);
      CHECK(load.force_lab == alone[c].force_lab);
      CHECK(load.arm_lab == alone[c].arm_lab);
      sum.add(load.force_lab, cross(load.arm_lab, load.force_lab));
      across += task_of(i) != task_of(load.partner);
    }
    const Wrench& expected = sim.particles().body(i).contact;
    CHECK((sum.force - expected.force).norm() <= 1e-9 * (1 + expected.force.norm()));
    CHECK(std::abs(sum.moment - expected.moment) <= 1e-9 * (1 + std::abs(expected.moment)));
  }
  CHECK(across > 20);
}
