// SPDX-License-Identifier: BSL-1.0
#include <riprap/measurement/energy.hpp>

#include <doctest/doctest.h>

#include <support/fake_contacts.hpp>
#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

const ConvexPolygon unit_square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

}  // namespace

TEST_CASE("kinetic energy is that of translation and of rotation") {
  Particles particles(0.02, 2500);  // mass 50 kg, polar inertia 50 / 6
  const BodyIndex i = particles.add(unit_square, Motion::free);
  particles.body(i).velocity = {3, 4};
  particles.body(i).angular_velocity = 6;
  CHECK(kinetic_energy(particles) == near_relative(0.5 * 50 * 25 + 0.5 * 50.0 / 6 * 36, 1e-14));
}

TEST_CASE("kinetic energy is that of the free bodies, with the masses that move") {
  Particles particles(0.02, 2500);
  const BodyIndex free = particles.add(unit_square, Motion::free);
  const BodyIndex wall = particles.add(unit_square, Motion::prescribed);
  const BodyIndex ring = particles.add(unit_square, Motion::strain_field);
  for (const BodyIndex i : {free, wall, ring}) particles.body(i).velocity = {2, 0};
  CHECK(kinetic_energy(particles) == near_relative(100, 1e-14));
  particles.body(free).mass_scaling = 3;
  CHECK(kinetic_energy(particles) == near_relative(300, 1e-14));
}

TEST_CASE("contacts store the energy of their two springs") {
  FakeContacts contacts;
  contacts.contact_law = {.normal_stiffness = 2e7, .tangential_stiffness = 1e7, .friction = 0.5};
  contacts.list.push_back(fake_contact(0, 1, {0, 0}, {1, 0}, {1, 0}, 2000, -300));
  contacts.list.push_back(fake_contact(0, 1, {0, 0}, {1, 0}, {1, 0}, 1000, 0));
  contacts.list[0].geometry.depth = 1e-4;
  contacts.list[1].geometry.depth = 5e-5;
  // F^2 / 2k for each spring.
  const double expected = (2000.0 * 2000 + 1000.0 * 1000) / 4e7 + 300.0 * 300 / 2e7;
  CHECK(stored_energy(contacts) == near_relative(expected, 1e-14));
  CHECK(stored_energy(FakeContacts{}) == 0);
}
