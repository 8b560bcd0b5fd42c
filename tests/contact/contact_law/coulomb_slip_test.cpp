// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <riprap/contact/contact_law/coulomb_slip.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near_relative;

TEST_CASE("a tangential spring below its cap takes up the whole motion") {
  // 100 N/m over 0.3 m against the motion.
  const CoulombSlip slip = coulomb_slip(10, 100, 3, 0.1, 50);
  CHECK(slip.force == near_relative(-20, 1e-14));
  CHECK(slip.friction_loss == 0);
}

TEST_CASE("beyond its cap a tangential spring slips against the mean force of the step") {
  // From -40 N the cap of 50 N is reached after 0.1 m; the other 0.2 m slip at 45 N.
  const CoulombSlip slip = coulomb_slip(-40, 100, 3, 0.1, 50);
  CHECK(slip.force == -50);
  CHECK(slip.friction_loss == near_relative(45 * 0.2, 1e-14));
  const CoulombSlip mirrored = coulomb_slip(40, 100, -3, 0.1, 50);
  CHECK(mirrored.force == 50);
  CHECK(mirrored.friction_loss == near_relative(slip.friction_loss, 1e-15));
}

TEST_CASE("without cap, stiffness or time a tangential spring loses only what it held") {
  CHECK(coulomb_slip(0, 100, 3, 0.1, 0).force == 0);
  CHECK(coulomb_slip(0, 100, 3, 0.1, 0).friction_loss == 0);
  CHECK(coulomb_slip(40, 100, 0, 0.1, 0).friction_loss ==
        near_relative(tangential_energy(40, 100), 1e-15));
  CHECK(coulomb_slip(0, 0, 3, 0.1, 50).force == 0);
  CHECK(coulomb_slip(0, 0, 3, 0.1, 50).friction_loss == 0);
  CHECK(coulomb_slip(-50, 100, 3, 0, 50).force == -50);
  CHECK(coulomb_slip(-50, 100, 3, 0, 50).friction_loss == 0);
}

TEST_CASE("a tangential spring stores half its force squared over its stiffness") {
  CHECK(tangential_energy(-40, 100) == near_relative(8, 1e-15));
  CHECK(tangential_energy(40, 0) == 0);
}

TEST_CASE("stiffness and friction below zero are refused, with the name of the law") {
  CHECK_NOTHROW(validate_coulomb_slip("Law", 0, 0));
  CHECK(test::message_of([] { validate_coulomb_slip("Law", -1, 0); }) ==
        "Law.tangential_stiffness = -1: must be a finite number, 0 or above");
  CHECK(test::message_of([] { validate_coulomb_slip("Law", 1, -0.5); }) ==
        "Law.friction = -0.5: must be a finite number, 0 or above");
}
