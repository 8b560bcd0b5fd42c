// SPDX-License-Identifier: BSL-1.0
#include <riprap/measurement/fabric.hpp>

#include <doctest/doctest.h>
#include <limits>
#include <vector>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <riprap/core/stress2.hpp>
#include <support/fake_contacts.hpp>
#include <support/near.hpp>
#include <support/synthetic_fabric.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

constexpr double pi = std::numbers::pi;

// Round-off of a sum over 1024 contacts of numbers of the order of one.
constexpr double round_off = 1e-12;

Fabric measured(const FakeContacts& contacts) { return fabric(contact_samples(contacts)); }

void check_same(const Anisotropy& measured, const Anisotropy& expected) {
  CHECK(measured.coefficient == near(expected.coefficient, round_off));
  // Directions are those of undirected lines.
  CHECK(std::abs(std::sin(measured.direction - expected.direction)) == near(0, 1e-11));
}

Fabric general_fabric() {
  return Series{.normals = {0.3, 0.4},
                .normal_forces = {0.45, 0.9},
                .tangential_forces = {0.2, -0.7},
                .normal_branches = {0.15, 1.3},
                .tangential_branches = {0.1, -1.2},
                .mean_normal_force = 820,
                .mean_branch = 0.016}
      .fabric();
}

// Contacts in given directions with no force.
FakeContacts contacts_along(std::initializer_list<double> directions) {
  FakeContacts contacts;
  for (const double theta : directions) {
    const Vec2 n{std::cos(theta), std::sin(theta)};
    contacts.list.push_back(fake_contact(0, 1, {0, 0}, n, n, 0, 0));
  }
  return contacts;
}

}  // namespace

TEST_CASE("every Fourier coefficient and direction of a synthetic set is found again") {
  const Fabric expected = general_fabric();
  const Fabric f = measured(synthetic_contacts(expected));
  check_same(f.normals, expected.normals);
  check_same(f.normal_forces, expected.normal_forces);
  check_same(f.tangential_forces, expected.tangential_forces);
  check_same(f.normal_branches, expected.normal_branches);
  check_same(f.tangential_branches, expected.tangential_branches);
  CHECK(f.mean_normal_force == near_relative(820, round_off));
  CHECK(f.mean_branch == near_relative(0.016, round_off));
}

TEST_CASE("contact normals with a = 0.4 have the moments 0.6 and 0.4") {
  const FakeContacts contacts = synthetic_contacts(Series{.normals = {0.4, 0}}.fabric());
  // Rothenburg 1980: the deviator of <n n> is a / 2.
  double f11 = 0;
  double f22 = 0;
  for (const ContactSample& s : contact_samples(contacts)) {
    f11 += s.normal.x() * s.normal.x() / 1024;
    f22 += s.normal.y() * s.normal.y() / 1024;
  }
  CHECK(f11 == near(0.6, round_off));
  CHECK(f22 == near(0.4, round_off));
  check_same(measured(contacts).normals, {0.4, 0});
}

TEST_CASE("force coefficients are averages over orientations, not over contacts") {
  const FakeContacts contacts = synthetic_contacts(
      Series{.normals = {0.5, 0}, .normal_forces = {0.8, 0}, .mean_normal_force = 100}.fabric());
  // The mean over contacts is larger: there are more of them where forces are large.
  double contact_mean = 0;
  for (const FakeContact& c : contacts.list) contact_mean += c.force.normal / 1024;
  CHECK(contact_mean == near(100 * (1 + 0.5 * 0.5 * 0.8), 1e-9));
  CHECK(measured(contacts).mean_normal_force == near(100, 1e-9));
  CHECK(measured(contacts).normal_forces.coefficient == near(0.8, round_off));
}

TEST_CASE("a force along axis 1 across a contact at 45 degrees has a negative tangential part") {
  // Forces of a uniform stress (Cauchy): f = S n on contacts all round. Then a_n and a_t are both
  // the deviator over the mean of S, and both point along its major direction.
  for (const double direction : {0.0, 0.5, -1.2, 1.5}) {
    CAPTURE(direction);
    const Stress2 s = Stress2{5, 3, 0}.rotated(Rotation::from_angle(direction));
    FakeContacts contacts;
    for (int k = 0; k < 12; ++k) {
      const double theta = 2 * pi * (k + 0.3) / 12;
      const Vec2 n{std::cos(theta), std::sin(theta)};
      const Vec2 force{s.s11 * n.x() + s.s12 * n.y(), s.s12 * n.x() + s.s22 * n.y()};
      contacts.list.push_back(
          fake_contact(0, 1, {0, 0}, n, n, force.dot(n), force.dot(perpendicular(n))));
      REQUIRE((contacts.list.back().force_on_b() - force).norm() == near(0, 1e-14));
    }
    const Fabric f = measured(contacts);
    CHECK(f.normals.coefficient == near(0, 1e-14));
    check_same(f.normal_forces, {0.25, direction});
    check_same(f.tangential_forces, {0.25, direction});
    CHECK(f.mean_normal_force == near(4, 1e-14));
  }
}

TEST_CASE("fabric does not depend on which body of a contact is called a") {
  FakeContacts contacts = synthetic_contacts(general_fabric());
  const Fabric before = measured(contacts);
  for (std::size_t i = 0; i < contacts.list.size(); i += 3)
    contacts.list[i] = exchanged(contacts.list[i]);
  const Fabric after = measured(contacts);
  check_same(after.normals, before.normals);
  check_same(after.normal_forces, before.normal_forces);
  check_same(after.tangential_forces, before.tangential_forces);
  check_same(after.normal_branches, before.normal_branches);
  check_same(after.tangential_branches, before.tangential_branches);
}

TEST_CASE("fabric turns with the assembly") {
  FakeContacts contacts = synthetic_contacts(general_fabric());
  const Rotation turn = Rotation::from_angle(0.81);
  for (FakeContact& c : contacts.list) {
    c.geometry.normal = turn * c.geometry.normal;
    c.arm_a = turn * c.arm_a;
    c.arm_b = turn * c.arm_b;
  }
  const Fabric f = measured(contacts);
  const Fabric e = general_fabric();
  check_same(f.normals, {e.normals.coefficient, e.normals.direction + 0.81});
  check_same(f.tangential_forces,
             {e.tangential_forces.coefficient, e.tangential_forces.direction + 0.81});
  check_same(f.tangential_branches,
             {e.tangential_branches.coefficient, e.tangential_branches.direction + 0.81});
}

TEST_CASE("a mirrored assembly has mirrored directions and the same coefficients") {
  FakeContacts contacts = synthetic_contacts(general_fabric());
  const auto mirror = [](Vec2& v) { v.x() = -v.x(); };
  for (FakeContact& c : contacts.list) {
    mirror(c.geometry.normal);
    mirror(c.arm_a);
    mirror(c.arm_b);
    // The tangent is the normal turned to the left: its mirror image points the other way.
    c.force.tangential = -c.force.tangential;
  }
  const Fabric f = measured(contacts);
  const Fabric e = general_fabric();
  check_same(f.normals, {e.normals.coefficient, -e.normals.direction});
  check_same(f.tangential_forces,
             {e.tangential_forces.coefficient, -e.tangential_forces.direction});
  check_same(f.tangential_branches,
             {e.tangential_branches.coefficient, -e.tangential_branches.direction});
}

TEST_CASE("coefficients have no unit") {
  Fabric small = general_fabric();
  small.mean_normal_force = 1e-9;
  small.mean_branch = 1e3;
  const Fabric f = measured(synthetic_contacts(small));
  check_same(f.tangential_forces, small.tangential_forces);
  check_same(f.tangential_branches, small.tangential_branches);
  CHECK(f.mean_normal_force == near_relative(1e-9, round_off));
}

TEST_CASE("hexagonal and square packings are isotropic at second order") {
  CHECK(measured(contacts_along({0.2, 0.2 + pi / 3, 0.2 + 2 * pi / 3})).normals.coefficient ==
        near(0, 1e-15));
  CHECK(measured(contacts_along({0.7, 0.7 + pi / 2})).normals.coefficient == near(0, 1e-15));
}

TEST_CASE("contacts all in one direction have a = 2") {
  const Fabric f = measured(contacts_along({0.3, 0.3, 0.3 + pi}));
  check_same(f.normals, {2, 0.3});
}

TEST_CASE("without contacts or without forces all coefficients are zero") {
  const Fabric none = fabric({});
  CHECK(none.normals.coefficient == 0);
  CHECK(none.mean_normal_force == 0);
  const Fabric forceless = measured(contacts_along({0.1, 1.3, 2.0}));
  CHECK(forceless.normal_forces.coefficient == 0);
  CHECK(forceless.tangential_forces.coefficient == 0);
  CHECK(forceless.mean_branch > 0);
}

TEST_CASE("directions lie in (-90, 90] degrees and coefficients are never negative") {
  for (double direction = -3; direction < 3; direction += 0.37) {
    const Fabric f = measured(synthetic_contacts(Series{.normals = {0.2, direction}}.fabric()));
    CHECK(f.normals.coefficient >= 0);
    CHECK(f.normals.direction > -0.5 * pi);
    CHECK(f.normals.direction <= 0.5 * pi);
    check_same(f.normals, {0.2, direction});
  }
}

TEST_CASE("seen from another axis a coefficient goes with cos 2") {
  const Anisotropy c{0.6, 0.4};
  CHECK(c.along(0.4) == 0.6);
  CHECK(c.along(0.4 + pi / 2) == near(-0.6, 1e-15));
  CHECK(c.along(0.4 - pi / 4) == near(0, 1e-15));
  CHECK(c.along(0.4 + pi / 6) == near(0.3, 1e-15));
}

TEST_CASE("samples carry the forces and branches of the contacts") {
  const FakeContacts contacts{.list = {fake_contact(0, 1, {1, 1}, {4, 5}, {0.6, 0.8}, 7, -2)}};
  const auto samples = contact_samples(contacts);
  REQUIRE(samples.size() == 1);
  CHECK(samples[0].normal == Vec2{0.6, 0.8});
  CHECK(samples[0].normal_force == 7);
  CHECK(samples[0].tangential_force == -2);
  CHECK((samples[0].branch - Vec2{3, 4}).norm() == near(0, 1e-15));
}

TEST_CASE("contacts that the density of eq. 9 gives no weight are counted") {
  // Nine contacts along axis 1 and one across: a = 2 * 0.8.
  std::vector<ContactSample> samples(9, {.normal = {1, 0}, .normal_force = 2});
  samples.push_back({.normal = {0, 1}, .normal_force = 5});
  const Fabric strong = fabric(samples);
  CHECK(strong.normals.coefficient == near_relative(1.6, 1e-14));
  CHECK(strong.left_out == 1);
  CHECK(strong.mean_normal_force == near_relative(2, 1e-14));
  samples.resize(20, {.normal = {0, 1}, .normal_force = 5});
  CHECK(fabric(samples).left_out == 0);
  samples[3].normal_force = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS((void)fabric(samples), InvalidInput);
}
