// SPDX-License-Identifier: BSL-1.0
#include <riprap/measurement/porosity.hpp>

#include <doctest/doctest.h>

#include <support/fake_contacts.hpp>
#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

struct FourOfRock {
  double area() const { return 16; }
  double solid_area() const { return 8.25; }
};

}  // namespace

TEST_CASE("porosity is what rock leaves over, with overlaps counted once") {
  const FourOfRock region;
  FakeContacts contacts;
  CHECK(porosity(region, contacts) == near(1 - 8.25 / 16, 1e-15));
  // Two contacts whose overlaps are 0.1 and 0.15.
  for (const double area : {0.1, 0.15}) {
    contacts.list.push_back(fake_contact(4, 5, {0, 0}, {1.95, 0}, {1, 0}, 1, 0));
    contacts.list.back().geometry.area = area;
  }
  CHECK(porosity(region, contacts) == near(1 - 8.0 / 16, 1e-15));
}
