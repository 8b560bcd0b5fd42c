// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/refused_cuts.hpp>

#include <doctest/doctest.h>

#include <vector>

#include <support/listed_contacts.hpp>

using namespace riprap;

TEST_CASE("a refused cut is identified by the ids of the partners, whatever their order") {
  const Particles particles = test::four_triangles();
  using Loads = std::vector<ContactLoad>;
  const auto from = [](BodyIndex partner) { return ContactLoad{.partner = partner}; };
  const std::uint64_t first = partners_hash(particles, Loads{from(1), from(2)});
  CHECK(partners_hash(particles, Loads{from(2), from(1)}) == first);
  CHECK(partners_hash(particles, Loads{from(1), from(3)}) != first);

  RefusedCuts refused;
  refused.resize(particles.size());
  refused.add(particles, 0, Loads{from(1), from(2)});
  CHECK(refused.contains(particles, 0, Loads{from(1), from(2)}));
  CHECK_FALSE(refused.contains(particles, 1, Loads{from(1), from(2)}));
  // Other partners discard the refusal.
  CHECK_FALSE(refused.contains(particles, 0, Loads{from(1), from(3)}));
  CHECK_FALSE(refused.contains(particles, 0, Loads{from(1), from(2)}));
}

TEST_CASE("refused cuts move up when a particle before them is removed") {
  const Particles particles = test::four_triangles();
  const std::vector<ContactLoad> loads{ContactLoad{.partner = 1}};
  RefusedCuts refused;
  refused.remove(0);  // nothing is known yet
  refused.resize(particles.size());
  refused.add(particles, 2, loads);
  refused.remove(0);
  CHECK(refused.contains(particles, 1, loads));
  CHECK_FALSE(refused.contains(particles, 2, loads));
}
