// SPDX-License-Identifier: BSL-1.0
#include <riprap/measurement/stress_force_fabric.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include <riprap/measurement/average_stress.hpp>
#include <support/near.hpp>
#include <support/synthetic_fabric.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

constexpr double pi = std::numbers::pi;

// Coefficients and sin phi by eq. 14 and by eq. 15, integrated numerically beforehand.
struct Row {
  double a, a_n, a_t;
  double full, simplified;
};
constexpr Row rows[] = {
    {0.2, 0.4, 0.1, 0.3365385, 0.35}, {0.3, 0.8, 0.2, 0.5803571, 0.65}, {0, 0.5, 0, 0.25, 0.25}};

// All axes along `direction`; branches of one length along the normals.
Fabric coaxial(const Row& row, double direction) {
  return Series{.normals = {row.a, direction},
                .normal_forces = {row.a_n, direction},
                .tangential_forces = {row.a_t, direction},
                .mean_normal_force = 500,
                .mean_branch = 0.016}
      .fabric();
}

// (major - minor) / (major + minor).
double strength_of(const Stress2& stress) { return stress.radius() / stress.mean(); }

void check_same(const Stress2& measured, const Stress2& expected) {
  // Round-off of sums over 1024 contacts.
  const double tolerance = 1e-12 * (std::abs(expected.mean()) + expected.radius());
  CHECK(measured.s11 == near(expected.s11, tolerance));
  CHECK(measured.s22 == near(expected.s22, tolerance));
  CHECK(measured.s12 == near(expected.s12, tolerance));
}

}  // namespace

TEST_CASE("eqs 14 and 15 for three sets of coefficients") {
  for (const Row& row : rows)
    for (const double axis : {0.0, pi / 2, 0.7}) {
      // Seven digits are printed.
      CHECK(sin_phi_from_fabric(coaxial(row, axis), axis) == near(row.full, 5.1e-8));
      CHECK(sin_phi_from_fabric_simplified(coaxial(row, axis), axis) ==
            near(row.simplified, 1e-15));
    }
}

TEST_CASE("for coaxial Fourier distributions eq. 14 is the strength of the contact forces") {
  for (const Row& row : rows) {
    CAPTURE(row.a);
    const FakeContacts contacts = synthetic_contacts(coaxial(row, pi / 2));
    const Stress2 stress = average_stress(contacts, 0.3, 0.016);
    const Fabric f = fabric(contact_samples(contacts));
    CHECK(sin_phi(stress) == near(row.full, 5.1e-8));
    CHECK(sin_phi_from_fabric(f, pi / 2) == near(sin_phi(stress), 1e-12));
    CHECK(sin_phi_from_fabric_simplified(f, pi / 2) == near(row.simplified, 1e-12));
  }
}

TEST_CASE("eq. 14 holds whatever the direction of the axes") {
  for (const double axis : {0.0, 0.3, -1.1, 2.0}) {
    const FakeContacts contacts = synthetic_contacts(coaxial(rows[1], axis));
    const Stress2 stress = average_stress(contacts, 1, 1);
    CHECK(strength_of(stress) == near(rows[1].full, 5.1e-8));
    CHECK(sin_phi_from_fabric(fabric(contact_samples(contacts)), axis) ==
          near(strength_of(stress), 1e-12));
    const Vec2 major = stress.principal().major_direction;
    CHECK(std::abs(cross(major, {std::cos(axis), std::sin(axis)})) == near(0, 1e-12));
  }
}

TEST_CASE("eq. 15 is eq. 14 times 1 + a a_n / 2") {
  const Fabric f = coaxial({0.35, 0.6, 0.15, 0, 0}, 0.4);
  CHECK(sin_phi_from_fabric_simplified(f, 0.4) ==
        near(sin_phi_from_fabric(f, 0.4) * (1 + 0.5 * 0.35 * 0.6), 1e-15));
}

TEST_CASE("with axes that do not coincide eq. 14 gives the deviator along its axis") {
  // Branches of one length along the normals. Products of two distributions have harmonics of order
  // zero and four, which change the mean and leave the deviator alone.
  const Series series{
      .normals = {0.25, 0.2}, .normal_forces = {0.5, -0.3}, .tangential_forces = {0.15, 0.6}};
  const FakeContacts contacts = synthetic_contacts(series.fabric());
  const Stress2 stress = average_stress(contacts, 1, 1);
  const Fabric f = fabric(contact_samples(contacts));
  for (const double axis : {0.0, 0.7, -0.4, 1.5}) {
    const Stress2 seen = stress.rotated(Rotation::from_angle(-axis));
    CHECK(sin_phi_from_fabric(f, axis) ==
          near((seen.s11 - seen.s22) / (seen.s11 + seen.s22), 1e-12));
  }
}

TEST_CASE("the full relation is the direct sum of f_i l_j") {
  const Series series{.normals = {0.3, 0.4},
                      .normal_forces = {0.45, 0.9},
                      .tangential_forces = {0.2, -0.7},
                      .normal_branches = {0.15, 1.3},
                      .tangential_branches = {0.1, -1.2},
                      .mean_normal_force = 820,
                      .mean_branch = 0.016};
  const FakeContacts contacts = synthetic_contacts(series.fabric());
  // Per contact: area times thickness is the number of contacts.
  const Stress2 direct = average_stress(contacts, 1024, 1);
  check_same(stress_from_fabric(series.fabric()), direct);
  check_same(stress_from_fabric(fabric(contact_samples(contacts))), direct);
}

TEST_CASE("the mean of an isotropic fabric is half of force times branch") {
  const Series series{.mean_normal_force = 600, .mean_branch = 0.02};
  const Stress2 stress = stress_from_fabric(series.fabric());
  check_same(stress, {6, 6, 0});
}

TEST_CASE("branch anisotropy adds to strength what eq. 14 leaves out") {
  Fabric f = coaxial(rows[0], 0);
  check_same(stress_from_fabric(f), average_stress(synthetic_contacts(f), 1024, 1));
  CHECK(strength_of(stress_from_fabric(f)) == near(sin_phi_from_fabric(f, 0), 1e-14));
  f.normal_branches = {0.1, 0};
  // Alone, b_n counts as a_n does: half of it.
  const Fabric alone = Series{.normal_branches = {0.1, 0}}.fabric();
  CHECK(strength_of(stress_from_fabric(alone)) == near(0.05, 1e-15));
  CHECK(strength_of(stress_from_fabric(f)) > sin_phi_from_fabric(f, 0) + 0.03);
}
