// SPDX-License-Identifier: BSL-1.0
#include <riprap/particle/bonded_cells.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <vector>

#include <riprap/bond/bond_law/brittle_bond.hpp>
#include <riprap/measurement/fragments.hpp>
#include <riprap/particle/random_assembly.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

Assembly sample() {
  Assembly all = random_assembly({.count = 40, .seed = 3});
  for (std::size_t k = 0; k < all.particles.size(); k += 3) all.particles[k].material = 1;
  return all;
}
constexpr VoronoiPoints nine{.count = 9, .seed = 5};

}  // namespace

TEST_CASE("every free particle is a cluster of its area and material") {
  const Assembly whole = sample();
  const Simulation sim{Model{}.bond_law(BrittleBond{}), bonded_cells(whole, nine),
                       Rocks{Rock{}, Rock{.density = 3000}}};
  const std::vector<Fragment> all = fragments(sim);
  REQUIRE(all.size() == whole.particles.size());
  for (std::size_t k = 0; k < all.size(); ++k) {
    const PlacedParticle& particle = whole.particles[k];
    const bool free = particle.motion == Motion::free;
    CHECK(all[k].bodies.size() == (free ? 9 : 1));
    CHECK(all[k].is_free == free);
    const AreaProperties properties = area_properties(particle.polygon);
    CHECK(all[k].area == near(properties.area, 1e-12 * properties.area));
    CHECK((all[k].centroid - properties.centroid).norm() < 1e-12);
    for (const BodyIndex i : all[k].bodies) {
      CHECK(sim.particles().material(i) == particle.material);
      CHECK(sim.particles().ancestry(i).root == sim.particles().ancestry(all[k].bodies[0]).id);
    }
  }
}

TEST_CASE("bonds are as long as the edges that cells have in common") {
  const Assembly whole = sample();
  const Assembly cut = bonded_cells(whole, nine);
  const auto perimeter = [](const ConvexPolygon& p) {
    double sum = 0;
    for (std::size_t k = 0; k < p.size(); ++k) sum += (p[(k + 1) % p.size()] - p[k]).norm();
    return sum;
  };
  double all = 0;
  double outer = 0;
  double bonds = 0;
  for (const PlacedParticle& p : cut.particles)
    if (p.motion == Motion::free) all += perimeter(p.polygon);
  for (const PlacedParticle& p : whole.particles)
    if (p.motion == Motion::free) outer += perimeter(p.polygon);
  for (const PlacedBond& b : cut.bonds) bonds += (b.ends[1] - b.ends[0]).norm();
  CHECK(bonds == near(0.5 * (all - outer), 1e-9 * all));
}

TEST_CASE("bonds are not made twice, and options are checked") {
  const Assembly cut = bonded_cells(sample(), nine);
  CHECK(contains(message_of([&] { (void)bonded_cells(cut); }), "must be none"));
  CHECK(contains(message_of([&] { (void)bonded_cells(sample(), {.count = 0}); }), "count = 0"));
}
