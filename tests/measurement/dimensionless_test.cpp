// SPDX-License-Identifier: BSL-1.0
#include <riprap/measurement/dimensionless.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <riprap/dynamics/body_force/uniform_body_force.hpp>
#include <support/fake_contacts.hpp>
#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

const ConvexPolygon unit_square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

struct State {
  Particles particles{1, 2};  // mass 2 kg each
  FakeContacts contacts;

  State() {
    for (int i = 0; i < 2; ++i) particles.add(unit_square, Motion::free);
    particles.add(unit_square, Motion::prescribed);
    // Forces of 5 and 13 N, of which 4 and 12 N along the normals.
    contacts.list.push_back(fake_contact(0, 1, {0, 0}, {1, 0}, {1, 0}, 4, 3));
    contacts.list.push_back(fake_contact(1, 2, {0, 0}, {1, 0}, {1, 0}, 12, -5));
    contacts.list[0].geometry.depth = 2e-3;
    contacts.list[1].geometry.depth = 6e-3;
    contacts.contact_law.normal_stiffness = 2000;
    contacts.contact_law.tangential_stiffness = 100;
  }
};

}  // namespace

TEST_CASE("the inertial number is rate times d sqrt(density / pressure)") {
  // 0.01 / s, 16 mm, 2500 kg/m3, 2.5 MPa: sqrt(1e-3) s/m * 1.6e-4 m/s.
  CHECK(inertial_number(0.01, 0.016, 2500, 2.5e6) == near_relative(5.0596442562694e-6, 1e-13));
  // Four times the pressure, half the number.
  CHECK(inertial_number(0.01, 0.016, 2500, 1e7) == near_relative(2.5298221281347e-6, 1e-13));
}

TEST_CASE("the stiffness level is pressure times thickness over stiffness") {
  CHECK(stiffness_level(2e6, 0.016, 2e7) == near_relative(1.6e-3, 1e-14));
  // With a thickness of a metre the same stress gives larger forces, and overlaps.
  CHECK(stiffness_level(14e6, 1, 2e7) == near_relative(0.7, 1e-14));
}

TEST_CASE("state numbers are means over contacts and free bodies") {
  State state;
  state.particles.body(0).contact.force = {0, 3};
  state.particles.body(1).contact.force = {-6, 8};
  state.particles.body(2).contact.force = {1e9, 0};  // a driven body balances nothing
  state.particles.body(0).velocity = {0.3, 0.4};
  const StateAverages n = state_averages(state.contacts, state.particles);
  CHECK(n.contacts == 2);
  CHECK(n.mean_normal_force == 8);
  CHECK(n.mean_overlap == near(4e-3, 1e-17));
  CHECK(n.largest_overlap == 6e-3);
  // Mean resultant (3 + 10) / 2 over mean contact force (5 + 13) / 2.
  CHECK(n.unbalanced_force == near(6.5 / 9, 1e-15));
  CHECK(n.kinetic_energy == near(0.25, 1e-15));
  const double stored = 0.5 * 2000 * (4e-6 + 36e-6) + (9.0 + 25.0) / 200;
  CHECK(n.stored_energy == near(stored, 1e-15));
  CHECK(n.kinetic_ratio() == near(0.25 / stored, 1e-14));
}

TEST_CASE("the unbalanced force has no unit and vanishes in equilibrium") {
  State state;
  CHECK(state_averages(state.contacts, state.particles).unbalanced_force == 0);
  state.particles.body(0).contact.force = {9, 0};
  state.particles.body(1).contact.force = {9, 0};
  CHECK(state_averages(state.contacts, state.particles).unbalanced_force == near(1, 1e-15));
  for (FakeContact& c : state.contacts.list) {
    c.force.normal *= 1e6;
    c.force.tangential *= 1e6;
  }
  for (Body& body : state.particles.bodies()) body.contact.force *= 1e6;
  CHECK(state_averages(state.contacts, state.particles).unbalanced_force == near(1, 1e-15));
}

TEST_CASE("a body force is part of the resultant: a body that rests on its support is balanced") {
  State state;
  state.particles.body(0).contact.force = {0, 2 * 9.81};
  state.particles.body(1).contact.force = {0, 2 * 9.81};
  const auto unbalanced = [&](const Vec2& body_force) {
    return state_averages(state.contacts, state.particles, UniformBodyForce{body_force})
        .unbalanced_force;
  };
  CHECK(unbalanced({0, -9.81}) == near(0, 1e-15));
  // Mean contact force 9 N.
  CHECK(unbalanced({0, 0}) == near(2 * 9.81 / 9, 1e-14));
  CHECK(unbalanced({0, 9.81}) == near(4 * 9.81 / 9, 1e-14));
}

TEST_CASE("the time step is measured by the lightest free body as it moves") {
  Particles particles(1, 2);
  particles.add(unit_square, Motion::free);                                      // 2 kg
  particles.add(ConvexPolygon{{0, 0}, {1, 0}, {0, 1}}, Motion::free);            // 1 kg
  particles.add(ConvexPolygon{{0, 0}, {0.1, 0}, {0, 0.1}}, Motion::prescribed);  // 10 g
  // sqrt(1 kg / 400 N/m) = 0.05 s.
  CHECK(time_step_ratio(0.006, particles, 400) == near(0.12, 1e-15));
  particles.body(1).mass_scaling = 1.44;
  CHECK(time_step_ratio(0.006, particles, 400) == near(0.1, 1e-15));
  particles.body(1).mass_scaling = 4;
  CHECK(time_step_ratio(0.006, particles, 400) == near(0.12 / std::sqrt(2.0), 1e-15));
}

TEST_CASE("without contacts there are no means and no ratios") {
  Particles particles(1, 2);
  particles.add(unit_square, Motion::free);
  particles.body(0).velocity = {1, 0};
  const StateAverages n = state_averages(FakeContacts{}, particles);
  CHECK(n.contacts == 0);
  CHECK(n.mean_normal_force == 0);
  CHECK(n.unbalanced_force == 0);
  CHECK(n.kinetic_energy == near(1, 1e-15));
  CHECK(n.kinetic_ratio() == 0);
}
