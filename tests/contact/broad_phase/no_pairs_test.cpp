// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/broad_phase/no_pairs.hpp>

#include <doctest/doctest.h>

#include <vector>

#include <riprap/contact/contact_law/linear_spring_coulomb.hpp>
#include <riprap/contact/contact_list.hpp>
#include <riprap/contact/narrow_phase/overlap_chord.hpp>
#include <support/rectangle.hpp>

using namespace riprap;

TEST_CASE("boxes that coincide are no pair where there are no pairs") {
  const std::vector<Box> boxes(3, Box{{0, 0}, {1, 1}});
  NoPairs{}.visit_pairs(std::span<const Box>(boxes), [](BodyIndex, BodyIndex) { FAIL("a pair"); });
}

TEST_CASE("bodies without pairs feel no contact, however deep they are in each other") {
  Particles particles(0.016, 2500);
  for (const double x : {0.0, 0.2, 0.5}) particles.add(test::rectangle({x, 0}, 1, 1), Motion::free);
  ContactList contacts{NoPairs{}, OverlapChord{}, LinearSpringCoulomb{}};
  contacts.update(particles, 0);
  CHECK(contacts.pairs().empty());
  for (const Body& body : particles.bodies()) CHECK(body.contact.force == Vec2{0, 0});
}
