// SPDX-License-Identifier: BSL-1.0
#include <riprap/acceleration/neighbour_list/verlet_list.hpp>

#include <doctest/doctest.h>

#include <riprap/contact/broad_phase/all_pairs.hpp>
#include <support/diamonds.hpp>

using namespace riprap;
using test::diamond;
using test::scattered;

namespace {

// A list whose skin is a tenth of the mean diameter of 0.1: 0.01.
using List = VerletList::State<PeriodicDomain>;

List searched(const Particles& particles, const PeriodicDomain& domain) {
  PairSearch<AllPairs, PeriodicDomain> search{AllPairs{.relative_skin = 0.1}};
  List list;
  CHECK(list.is_stale(particles, domain));
  list.rebuilt(particles, domain,
               search.visit_pairs(particles, domain, true, [](auto, auto, auto) {}));
  return list;
}

}  // namespace

TEST_CASE("the shrinking of the cell makes the pairs stale before any can be missing") {
  Particles particles(1, 1);
  particles.add(diamond({0, 0}, 0.05), Motion::free);
  particles.add(diamond({0.4, 0}, 0.05), Motion::free);
  PeriodicDomain domain{.period = {1, 1}};
  List list = searched(particles, domain);
  CHECK_FALSE(list.is_stale(particles, domain));
  // An image at rest may come nearer by the skin.
  domain.period = {0.995, 1};
  CHECK_FALSE(list.is_stale(particles, domain));
  SUBCASE("of itself") {
    domain.period = {0.985, 1};
    CHECK(list.is_stale(particles, domain));
  }
  SUBCASE("together with what the bodies have used up") {
    particles.body(0).position.x() -= 0.0031;
    CHECK(list.is_stale(particles, domain));
  }
}

TEST_CASE("the shear of the cell makes the pairs stale before any can be missing") {
  Particles particles(1, 1);
  particles.add(diamond({0, 0}, 0.05), Motion::free);
  particles.add(diamond({0.4, 0}, 0.05), Motion::free);
  PeriodicDomain domain{.period = {1, 1}};
  List list = searched(particles, domain);
  domain.shear_offset = 0.004;
  CHECK_FALSE(list.is_stale(particles, domain));
  domain.shear_offset = 0.02;  // 0.008 would go on as before
  CHECK(list.is_stale(particles, domain));
}

TEST_CASE("a list is stale when bodies were added, and when it was invalidated") {
  Particles particles = scattered(5, 1, 0.05, 1);
  const PeriodicDomain domain{.period = {3, 3}};
  List list = searched(particles, domain);
  CHECK_FALSE(list.is_stale(particles, domain));
  list.invalidate();
  CHECK(list.is_stale(particles, domain));
  list = searched(particles, domain);
  particles.add(diamond({0, 0}, 0.05), Motion::free);
  CHECK(list.is_stale(particles, domain));
}

TEST_CASE("the threshold of a gap is reached when bodies may have closed it") {
  Particles particles(1, 1);
  particles.add(diamond({0, 0}, 0.05), Motion::free);
  particles.add(diamond({0.2, 0}, 0.05), Motion::free);
  particles.add(diamond({2, 2}, 0.05), Motion::free);
  const PeriodicDomain domain{.period = {5, 5}};
  List list = searched(particles, domain);
  const double threshold = list.contact_threshold(0.004);
  CHECK(list.displacement() < threshold);
  // One body alone covers half of the gap, with a bound of twice its displacement's square.
  particles.body(1).position.x() -= 0.0013;
  CHECK_FALSE(list.is_stale(particles, domain));
  CHECK(list.displacement() < threshold);
  particles.body(1).position.x() -= 0.0008;
  (void)list.is_stale(particles, domain);
  CHECK(list.displacement() >= threshold);
}
