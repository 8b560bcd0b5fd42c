// SPDX-License-Identifier: BSL-1.0
#include <riprap/measurement/coordination.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include <riprap/measurement/fabric.hpp>
#include <support/fake_contacts.hpp>
#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

const ConvexPolygon small_square{{-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1}, {-0.1, 0.1}};

// n by n particles on a torus, each in contact with its neighbours in `directions` half-planes.
struct Packing {
  Particles particles{1, 1};
  FakeContacts contacts;

  Packing(unsigned n, bool hexagonal) {
    for (unsigned i = 0; i < n * n; ++i) particles.add(small_square, Motion::free);
    const auto index = [n](unsigned i, unsigned j) { return (j % n) * n + i % n; };
    const auto connect = [&](unsigned p, unsigned q, double theta) {
      const Vec2 normal{std::cos(theta), std::sin(theta)};
      contacts.list.push_back(fake_contact(p, q, {0, 0}, normal, normal, 1, 0));
    };
    using std::numbers::pi;
    for (unsigned j = 0; j < n; ++j)
      for (unsigned i = 0; i < n; ++i) {
        connect(index(i, j), index(i + 1, j), 0);
        connect(index(i, j), index(i, j + 1), hexagonal ? pi / 3 : pi / 2);
        if (hexagonal) connect(index(i, j), index(i + n - 1, j + 1), 2 * pi / 3);
      }
  }
};

}  // namespace

TEST_CASE("in a hexagonal packing every particle has six neighbours and three contacts") {
  const Packing packing(5, true);
  const Coordination c = coordination(packing.contacts, packing.particles);
  CHECK(c.contacts_per_particle == 3);
  CHECK(c.coordination_number == 6);
  const Fabric f = fabric(contact_samples(packing.contacts));
  CHECK(f.normals.coefficient == near(0, 1e-15));
  CHECK(f.normal_forces.coefficient == near(0, 1e-15));
}

TEST_CASE("in a square lattice every particle has four neighbours and two contacts") {
  const Packing packing(4, false);
  const Coordination c = coordination(packing.contacts, packing.particles);
  CHECK(c.contacts_per_particle == 2);
  CHECK(c.coordination_number == 4);
  CHECK(fabric(contact_samples(packing.contacts)).normals.coefficient == near(0, 1e-15));
}

TEST_CASE("a contact with a driven particle counts for one side only") {
  Particles particles(1, 1);
  const BodyIndex free_a = particles.add(small_square, Motion::free);
  const BodyIndex free_b = particles.add(small_square, Motion::free);
  const BodyIndex wall = particles.add(small_square, Motion::prescribed);
  const BodyIndex ring = particles.add(small_square, Motion::strain_field);
  FakeContacts contacts;
  const auto connect = [&](BodyIndex p, BodyIndex q) {
    contacts.list.push_back(fake_contact(p, q, {0, 0}, {1, 0}, {1, 0}, 1, 0));
  };
  connect(free_a, free_b);
  connect(free_a, wall);
  connect(free_b, ring);
  connect(wall, free_b);
  connect(ring, free_a);
  const Coordination c = coordination(contacts, particles);
  // Three contacts at each of the two free particles.
  CHECK(c.coordination_number == 3);
  CHECK(c.contacts_per_particle == 1.5);
}

TEST_CASE("without free particles or without contacts the coordination is zero") {
  Particles particles(1, 1);
  particles.add(small_square, Motion::prescribed);
  CHECK(coordination(FakeContacts{}, particles).coordination_number == 0);
  particles.add(small_square, Motion::free);
  CHECK(coordination(FakeContacts{}, particles).coordination_number == 0);
}

TEST_CASE("every body has its contacts counted, and their mean is the coordination number") {
  const Packing packing(5, true);
  for (const unsigned count : contact_counts(packing.contacts, packing.particles))
    CHECK(count == 6);
  Packing broken(4, false);
  broken.contacts.list.resize(3);  // 0-1, 0-4, 1-2
  const auto counts = contact_counts(broken.contacts, broken.particles);
  REQUIRE(counts.size() == 16);
  CHECK(counts[0] == 2);
  CHECK(counts[1] == 2);
  CHECK(counts[2] == 1);
  CHECK(counts[4] == 1);
  CHECK(counts[3] == 0);
}
