// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/concepts.hpp>

#include <doctest/doctest.h>

#include <riprap/simulation/simulation.hpp>
#include <support/fake_contacts.hpp>
#include <support/listed_contacts.hpp>

using namespace riprap;

TEST_CASE("measurements need touching contacts, loads need those of a list") {
  using Real = Simulation<Model<>>::Contacts;
  CHECK(TouchingContacts<Real>);
  CHECK(ListedContacts<Real>);
  CHECK(TouchingContacts<test::FakeContacts>);
  CHECK_FALSE(ListedContacts<test::FakeContacts>);
  CHECK(ListedContacts<test::Touches>);
  CHECK_FALSE(TouchingContacts<std::vector<int>>);
}
