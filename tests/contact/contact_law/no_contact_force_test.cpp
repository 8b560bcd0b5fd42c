// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <riprap/contact/contact_law/no_contact_force.hpp>

using namespace riprap;

TEST_CASE("bodies without contact forces pass through each other and store nothing") {
  const NoContactForce law;
  NoContactForce::History history;
  ContactGeometry geometry;
  geometry.depth = 1;
  geometry.area = 1;
  const ContactForce force =
      law(geometry, {.normal_velocity = -5, .tangential_velocity = 3, .time_step = 1}, history);
  CHECK(force.normal == 0);
  CHECK(force.tangential == 0);
  CHECK(force.friction_loss == 0);
  CHECK(force.viscous_loss == 0);
  CHECK(law.stored_energy(geometry, history) == 0);
  CHECK(law.peak_stiffness() > 0);  // a time step needs one
}
