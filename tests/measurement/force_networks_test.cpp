// SPDX-License-Identifier: BSL-1.0
#include <riprap/measurement/force_networks.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include <riprap/particle/random_assembly.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/fake_contacts.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

/// Contacts of unit branches along their normals.
void add(FakeContacts& contacts, double direction, double normal, double tangential = 0) {
  const Vec2 n{std::cos(direction), std::sin(direction)};
  contacts.list.push_back(fake_contact(0, 1, {0, 0}, n, n, normal, tangential));
}

constexpr double pi = std::numbers::pi;

}  // namespace

TEST_CASE("strong contacts along axis 2 carry the deviator, weak ones across it take from it") {
  FakeContacts contacts;
  for (int k = 0; k < 2; ++k) add(contacts, pi / 2, 9);  // strong
  for (int k = 0; k < 4; ++k) add(contacts, 0, 3);       // weak: the mean is 5
  add(contacts, 0.3, 0);                                 // not loaded
  const ForceNetworks n = force_networks(contacts, 2, 0.5);
  CHECK(n.mean_normal_force == 5);
  CHECK(n.strong.contacts == 2);
  CHECK(n.weak.contacts == 4);
  CHECK(n.strong.contact_share == near(1.0 / 3, 1e-15));
  CHECK(n.strong.force_share == near(0.6, 1e-15));
  CHECK(n.weak.force_share == near(0.4, 1e-15));
  // sigma = sum of f l / (A t) with A t = 1.
  CHECK(n.strong.stress.s22 == near(18, 1e-12));
  CHECK(n.strong.stress.s11 == near(0, 1e-12));
  CHECK(n.weak.stress.s11 == near(12, 1e-12));
  CHECK(n.strong.mean_share == near(0.6, 1e-14));
  // Deviators, s22 - s11 halved: 9 and -6 of 3.
  CHECK(n.strong.deviator_share == near(3, 1e-13));
  CHECK(n.weak.deviator_share == near(-2, 1e-13));
  // All normals in one direction: a = 2.
  CHECK(n.strong.fabric.normals.coefficient == near(2, 1e-14));
  CHECK(std::abs(n.strong.fabric.normals.direction) == near(pi / 2, 1e-14));
  CHECK(n.weak.fabric.normals.direction == near(0, 1e-14));
}

TEST_CASE("shares of the deviator are those along the principal directions of the whole") {
  FakeContacts contacts;
  add(contacts, 0.4, 10);
  add(contacts, 0.4 + pi / 4, 2);  // its deviator is at right angles to that of the first
  const ForceNetworks n = force_networks(contacts, 1, 1);
  // Deviators as vectors of length f / 2 at twice the angle: (5, 0) and (0, 1).
  CHECK(n.strong.deviator_share == near(25.0 / 26, 1e-14));
  CHECK(n.weak.deviator_share == near(1.0 / 26, 1e-14));
}

TEST_CASE("a threshold of twice the mean leaves fewer contacts in the strong network") {
  FakeContacts contacts;
  for (const double force : {1.0, 2.0, 3.0, 10.0}) add(contacts, force, force);
  CHECK(force_networks(contacts, 1, 1, 0.5).strong.contacts == 2);  // above 2
  CHECK(force_networks(contacts, 1, 1).strong.contacts == 1);       // above 4
  CHECK(force_networks(contacts, 1, 1, 3).strong.contacts == 0);    // above 12
  CHECK(force_networks(contacts, 1, 1, 3).weak.deviator_share == near(1, 1e-14));
}

TEST_CASE("without loaded contacts all is zero, and an area of zero is refused") {
  FakeContacts contacts;
  CHECK(force_networks(contacts, 1, 1).mean_normal_force == 0);
  add(contacts, 0, 0);
  CHECK(force_networks(contacts, 1, 1).strong.contacts == 0);
  CHECK(contains(message_of([&] { (void)force_networks(contacts, 0, 1); }),
                 "force_networks: area = 0"));
  CHECK(contains(message_of([&] { (void)force_networks(contacts, 1, 1, -1); }),
                 "force_networks: threshold = -1"));
}

TEST_CASE("in a sheared sample the networks add up to its stress and contacts") {
  Simulation sim{Model{}.criterion(NeverFails{}), random_assembly({.count = 120, .seed = 4}),
                 Rock{}};
  sim.boundary().set_rate(20, 20);
  for (int i = 0; i < 6500; ++i) sim.step();
  const double area = sim.boundary().region(sim.particles()).area();
  const double thickness = sim.particles().thickness();
  const ForceNetworks n = force_networks(sim.contacts(), area, thickness);
  const Stress2 whole = average_stress(sim.contacts(), area, thickness);
  const double tolerance = 1e-13 * whole.mean();
  CHECK(n.strong.stress.s11 + n.weak.stress.s11 == near(whole.s11, tolerance));
  CHECK(n.strong.stress.s22 + n.weak.stress.s22 == near(whole.s22, tolerance));
  CHECK(n.strong.stress.s12 + n.weak.stress.s12 == near(whole.s12, tolerance));
  for (const double sum :
       {n.strong.contact_share + n.weak.contact_share, n.strong.force_share + n.weak.force_share,
        n.strong.mean_share + n.weak.mean_share, n.strong.deviator_share + n.weak.deviator_share})
    CHECK(sum == near(1, 1e-13));
  CHECK(n.strong.contacts > 10);
  CHECK(n.weak.contacts > n.strong.contacts);
  // A force above the mean is more than its share of the contacts.
  CHECK(n.strong.force_share > n.strong.contact_share);
}
