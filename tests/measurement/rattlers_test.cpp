// SPDX-License-Identifier: BSL-1.0
#include <riprap/measurement/rattlers.hpp>

#include <doctest/doctest.h>

#include <cstdint>
#include <vector>

#include <riprap/measurement/coordination.hpp>
#include <riprap/particle/random_assembly.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/fake_contacts.hpp>
#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

using Contacts = std::vector<LoadedContact>;

std::vector<bool> all_free(std::size_t count) { return std::vector<bool>(count, true); }

/// What is left when bodies are searched again and again, in rising order.
std::vector<bool> by_repeated_search(const Contacts& contacts, const std::vector<bool>& is_free,
                                     unsigned fewest) {
  std::vector<bool> removed(is_free.size(), false);
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < is_free.size(); ++i) {
      unsigned count = 0;
      for (const auto& [a, b] : contacts)
        if ((a == i && !removed[b]) || (b == i && !removed[a])) ++count;
      if (is_free[i] && !removed[i] && count < fewest) removed[i] = changed = true;
    }
  }
  return removed;
}

}  // namespace

TEST_CASE("a ring of particles carries load, and a chain that hangs on it does not") {
  // 0-1-2-3 is closed; 3-4-5 is open: 5 has one contact, and 4 has one without 5. 6 touches none.
  const Contacts contacts{{0, 1}, {1, 2}, {2, 3}, {0, 3}, {3, 4}, {4, 5}};
  CHECK(rattlers(contacts, all_free(7)) ==
        std::vector<bool>{false, false, false, false, true, true, true});
  const MechanicalCoordination z = mechanical_coordination(contacts, all_free(7));
  CHECK(z.particles == 7);
  CHECK(z.rattlers == 3);
  CHECK(z.loaded == near_relative(12.0 / 7, 1e-15));
  // N_c = 6, N_0 = 1 (6), N_1 = 1 (5): 4 stays, with its contact to 5.
  CHECK(z.mechanical == near_relative((2 * 6.0 - 1) / (7 - 1 - 1), 1e-15));
  CHECK(z.rattler_free == 2);
  CHECK(z.rattler_share() == near_relative(3.0 / 7, 1e-15));
}

TEST_CASE(
    "a chain between two driven bodies carries load, one that ends at a driven body does not") {
  // 0 and 1 are driven. 0-2-3-1 reaches from one to the other; 0-4-5 does not.
  const std::vector<bool> is_free{false, false, true, true, true, true};
  const Contacts contacts{{0, 2}, {2, 3}, {1, 3}, {0, 4}, {4, 5}};
  CHECK(rattlers(contacts, is_free) == std::vector<bool>{false, false, false, false, true, true});
  const MechanicalCoordination z = mechanical_coordination(contacts, is_free);
  // Seven ends at four free particles; two particles with two ends each.
  CHECK(z.loaded == 7.0 / 4);
  CHECK(z.rattler_free == 2);
}

TEST_CASE("without friction three contacts are needed") {
  const Contacts square{{0, 1}, {1, 2}, {2, 3}, {0, 3}};
  CHECK(rattlers(square, all_free(4), 3) == std::vector<bool>(4, true));
  // With both diagonals each has three.
  const Contacts braced{{0, 1}, {1, 2}, {2, 3}, {0, 3}, {0, 2}, {1, 3}};
  CHECK(rattlers(braced, all_free(4), 3) == std::vector<bool>(4, false));
}

TEST_CASE("contacts without a force count for nothing") {
  const ConvexPolygon square{{-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1}, {-0.1, 0.1}};
  Particles particles(1, 1);
  for (int i = 0; i < 3; ++i) particles.add(square, Motion::free);
  FakeContacts contacts;
  const auto connect = [&](BodyIndex a, BodyIndex b, double normal) {
    contacts.list.push_back(fake_contact(a, b, {0, 0}, {1, 0}, {1, 0}, normal, 0));
  };
  connect(0, 1, 5);
  connect(1, 2, 5);
  connect(0, 2, 0);
  CHECK(coordination(contacts, particles).coordination_number == 2);
  CHECK(mechanical_coordination(contacts, particles).rattlers == 3);
  contacts.list.back().force.normal = 5;
  CHECK(mechanical_coordination(contacts, particles).rattlers == 0);
  CHECK(mechanical_coordination(contacts, particles).rattler_free == 2);
}

TEST_CASE("without particles, and with rattlers alone, all numbers are zero") {
  CHECK(mechanical_coordination(Contacts{}, {}).loaded == 0);
  CHECK(mechanical_coordination(Contacts{}, {}).rattler_share() == 0);
  const MechanicalCoordination z = mechanical_coordination(Contacts{{0, 1}}, all_free(2));
  CHECK(z.loaded == 1);
  CHECK(z.mechanical == 0);
  CHECK(z.rattler_free == 0);
  CHECK(z.rattler_share() == 1);
}

TEST_CASE("random networks keep what repeated search keeps") {
  std::uint32_t state = 1;
  const auto next = [&](std::uint32_t below) {
    state = state * 1664525u + 1013904223u;
    return (state >> 8) % below;
  };
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<bool> is_free(40);
    for (std::size_t i = 0; i < is_free.size(); ++i) is_free[i] = next(8) > 0;
    Contacts contacts;
    for (int k = 0; k < 50; ++k) {
      const BodyIndex a = next(39);
      contacts.push_back({a, a + 1 + next(39 - a)});
    }
    for (const unsigned fewest : {2u, 3u})
      CHECK(rattlers(contacts, is_free, fewest) == by_repeated_search(contacts, is_free, fewest));
  }
}

TEST_CASE("particles of a pressed sample that are no rattlers have two contacts or more") {
  Simulation sim{Model{}.criterion(NeverFails{}), random_assembly({.count = 120, .seed = 4}),
                 Rock{}};
  sim.boundary().set_rate(20, 20);
  for (int i = 0; i < 6500; ++i) sim.step();
  const auto is_rattler = rattlers(sim.contacts(), sim.particles());
  const MechanicalCoordination z = mechanical_coordination(sim.contacts(), sim.particles());
  CHECK(z.rattlers > 0);
  CHECK(z.rattlers < z.particles / 2);
  CHECK(z.loaded <= coordination(sim.contacts(), sim.particles()).coordination_number);
  CHECK(z.rattler_free >= 2);
  CHECK(z.mechanical > z.loaded);
  for (BodyIndex i = 0; i < sim.particles().size(); ++i)
    if (!sim.particles().body(i).is_free()) CHECK(!is_rattler[i]);
}
