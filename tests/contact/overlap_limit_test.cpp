// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/overlap_limit.hpp>

#include <doctest/doctest.h>

#include <support/fake_contacts.hpp>
#include <support/rectangle.hpp>

using namespace riprap;

TEST_CASE("an overlap of more than three quarters of the smaller particle names both") {
  Particles particles(1, 2500);
  particles.add(test::rectangle({0, 0}, 2, 2), Motion::free);
  particles.add(test::rectangle({1, 0}, 1, 1), Motion::free);
  test::FakeContacts contacts{.list = {test::fake_contact(0, 1, {0, 0}, {1, 0}, {1, 0}, 1, 0)}};
  contacts.list[0].geometry.area = 0.75;
  CHECK_NOTHROW(refuse_deep_overlaps(contacts, particles));
  contacts.list[0].geometry.area = 0.8;
  CHECK_THROWS_WITH_AS(refuse_deep_overlaps(contacts, particles),
                       "particle 0 and particle 1 overlap in 0.8 of the area of the smaller one: "
                       "at most 0.75 makes a contact",
                       SimulationError);
}
